#pragma once

// Rotation vectors of spherical joints along a motion: their rates are not velocities. With the
// sense s of a coordinate (SubsystemCoordinate::sense), v = H(s theta) theta'.

#include <Eigen/Core>
#include <vector>

#include "engine/small_motions/vibration/periodic_system.h"
#include "engine/small_motions/vibration/turn_motion.h"

namespace spoke::vibration {

/// A rotation vector among the coordinates of a PeriodicSystem.
struct RotationAt {
  Eigen::Index at = 0;  ///< first of its three coordinates
  double sense = 1.0;
};

std::vector<RotationAt> list_rotations(const PeriodicSystem& mean,
                                       const steady::SteadyModel& model);

/// Takes rates of coordinates, and those of these, to velocities and accelerations.
TurnMotion find_velocities(const TurnMotion& rates, const std::vector<RotationAt>& rotations);

/// Derivatives of velocities and accelerations by coordinates x and their rates; those of
/// velocities by x' and of accelerations by x'' are equal.
struct RateMaps {
  Eigen::MatrixXd v_by_x, v_by_rate, a_by_x, a_by_rate;
};

/// Returns them at the l-th azimuth, for the first `hub` coordinates and `count` from `at` on.
RateMaps find_rate_maps(const TurnMotion& rates, Eigen::Index l,
                        const std::vector<RotationAt>& rotations, Eigen::Index hub, Eigen::Index at,
                        Eigen::Index count);

}  // namespace spoke::vibration
