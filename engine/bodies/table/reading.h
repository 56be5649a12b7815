#pragma once

// The readings that a sensor of the scenario's takes from a subsystem.

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/bodies/body_types.h"
#include "engine/bodies/plane/section.h"
#include "engine/bodies/space/body.h"
#include "engine/bodies/space/solid_output.h"
#include "models/sensor.h"
#include "models/system/blade_loads.h"

namespace spoke {

/// Mass at a section of a planar body, a point of an integral over it or a point mass.
struct MassPoint {
  double mass = 0.0;     ///< [kg]
  double inertia = 0.0;  ///< [kg m^2]
  plane::Section section;
};
/// The mass points of a body, or of its part outboard of a section; bodies that are alike share
/// them.
using MassPoints = std::shared_ptr<const std::vector<MassPoint>>;

/// A sensor on its planar subsystem.
template <class World>
struct Reading {
  SensorQuantity quantity = SensorQuantity::displacement;
  SensorFrame frame = SensorFrame::hub;
  int body = 0;          ///< body of the section, or the one outboard of the joint
  double station = 0.0;  ///< place of the section on its body, 0 to 1
  typename BodyTypes<World>::Section section;
  std::size_t loop = 0;   ///< index of the loop that it is on
  std::size_t first = 0;  ///< place of its values among those of the subsystem
  /// For a section's force the points of the body outboard of the section, for a momentum those of
  /// each body.
  std::vector<MassPoints> masses;
};

/// A load of the scenario's, as far as it acts at a section of its body and outboard of it.
struct OutboardLoad {
  BodyLoad<Space> load;
  std::vector<space::Section> sections;  ///< by point
};

/// A sensor on its spatial subsystem.
template <>
struct Reading<Space> {
  SensorQuantity quantity = SensorQuantity::displacement;
  SensorFrame frame = SensorFrame::hub;
  /// Bodies from the hub to that of the section, to the one outboard of the joint, or to that of a
  /// loop's place `from`.
  std::vector<int> path;
  std::size_t loop = 0;  ///< index of the loop that it is on
  space::Section section;
  space::Pose rest;  ///< pose of the section in H, undeformed and with all joint coordinates zero
  std::size_t first = 0;  ///< place of its values among those of the subsystem
  // Members for a section's force.
  /// Where it is on its body, in elements from the inboard end; in air, in stations from the root.
  double along = 0.0;
  space::SlotMatrix mass = space::SlotMatrix::Zero();  ///< mass of its element's part outboard
  std::vector<OutboardLoad> loads;
  /// Of a von Mises stress: the nodes of which it is the largest; bodies that are alike share them.
  std::shared_ptr<const space::NodeRecovery> recovery;

  int body() const { return path.back(); }
  /// Whether it shows the load of the first joint on the subsystem.
  bool is_root() const { return path.size() == 1 && along == 0.0; }
};

}  // namespace spoke
