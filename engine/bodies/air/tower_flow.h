#pragma once

// What a tower does to the wind around it: upwind and beside it potential flow around a cylinder,
// downwind a shadow. Pure functions of their arguments. Equations: docs/aerodynamics.md.

#include <Eigen/Core>
#include <span>

#include "models/air.h"
#include "spoke/export.h"

namespace spoke::air {

/// A point of a tower's axis.
struct TowerPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< inertial frame [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  double diameter = 0.0;                               ///< [m]
  double coefficient = 0.0;                            ///< of drag, by the diameter
};

/// How a tower disturbs the wind.
struct TowerFlow {
  spatial::TowerPotential potential = spatial::TowerPotential::none;
  spatial::TowerShadow shadow = spatial::TowerShadow::none;
};

/// Velocities that a cylinder adds, by the undisturbed wind across it.
struct CylinderFlow {
  double along = 0.0;   ///< the wind
  double across = 0.0;  ///< towards positive y
};

/// Returns what a cylinder adds to wind along x at a place (x, y) from its axis, by its radius.
/// Within the cylinder it is that on its surface. coefficient: of drag.
SPOKE_EXPORT CylinderFlow calc_cylinder_flow(const TowerFlow& flow, double x, double y,
                                             double coefficient) noexcept;

/// Returns the velocity that a tower adds to the wind at a place [m/s]. axis: two points or more,
/// straight between them; wind: undisturbed. Beyond the ends of the axis it fades within a radius.
SPOKE_EXPORT Eigen::Vector3d calc_tower_flow(const TowerFlow& flow,
                                             std::span<const TowerPoint> axis,
                                             const Eigen::Vector3d& place,
                                             const Eigen::Vector3d& wind) noexcept;

}  // namespace spoke::air
