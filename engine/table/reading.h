#pragma once

// What a sensor of the scenario's measures on a blade.

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/body/body_types.h"
#include "engine/body/section.h"
#include "models/sensor.h"

namespace spoke {

/// Mass at a section of a planar body, a point of an integral over it or a point mass.
struct MassPoint {
  double mass = 0.0;     ///< [kg]
  double inertia = 0.0;  ///< [kg m^2]
  Section section;
};
/// Those of a body, or of its part outboard of a section; bodies that are alike share them.
using MassPoints = std::shared_ptr<const std::vector<MassPoint>>;

/// A sensor on its blade.
template <class World>
struct Reading {
  SensorQuantity quantity = SensorQuantity::displacement;
  SensorFrame frame = SensorFrame::hub;
  int body = 0;          ///< of the section, or the body outboard of the joint
  double station = 0.0;  ///< of the section on its body, 0 to 1
  typename BodyTypes<World>::Section section;
  std::size_t first = 0;  ///< place of its values among those of the blade
  /// Of a section's force that of the body outboard of the section, of a momentum that of each
  /// body.
  std::vector<MassPoints> masses;
};

}  // namespace spoke
