#pragma once

// What a sensor of the scenario's measures on a blade.

#include <cstddef>

#include "engine/body/body_types.h"
#include "models/sensor.h"

namespace spoke {

/// A sensor on its blade.
template <class World>
struct Reading {
  SensorQuantity quantity = SensorQuantity::displacement;
  SensorFrame frame = SensorFrame::hub;
  int body = 0;          ///< of the section, or the body outboard of the joint
  double station = 0.0;  ///< of the section on its body, 0 to 1
  typename BodyTypes<World>::Section section;
  std::size_t first = 0;  ///< place of its values among those of the blade
};

}  // namespace spoke
