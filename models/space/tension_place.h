#pragma once

// What the tension in a body follows from.

#include "models/space/rotation.h"

namespace spoke::space {

/// Where a body stands in its tree, undeformed and with joint coordinates zero, seen from the hub:
/// from this follows the tension that the hub's rotation and gravity put on it.
struct TensionPlace {
  Rotation R_HB;                                ///< from B to the hub frame H
  Position origin = Position::Zero();           ///< of B, from the hub's centre [m]
  Position outboard_moment = Position::Zero();  ///< first moment, about the hub's centre, of all
                                                ///< that is outboard of the body [kg m]
  double outboard_mass = 0.0;                   ///< [kg]
};

}  // namespace spoke::space
