#pragma once

// Names of modes of shafts seen from outside.

#include <string>

#include "engine/small_motions/vibration/mode_shapes.h"

namespace spoke::vibration {

/// What a shaft does in a mode.
struct ShaftMotion {
  std::string kind;   ///< "whirl", "torsion" or "axial", by the largest kinetic energy
  std::string sense;  ///< of a whirl that goes round: "forward", as the hub, or "backward"
};

/// Describes a shape that vibrates as exp(i w t), w not negative. `speed`: of the hub [rad/s]; at
/// rest "forward" is about the axis.
ShaftMotion describe_shaft(const SubsystemShape& shape, double speed);

}  // namespace spoke::vibration
