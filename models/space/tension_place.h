#pragma once

// What the tension in a body follows from.

#include <vector>

#include "models/space/rotation.h"

namespace spoke::space {

/// What elements carry besides the mass of their own body: all that hangs at nodes further out.
struct CarriedMass {
  int end = 0;                         ///< of the elements before this one that no other holds for
  Position moment = Position::Zero();  ///< first moment about the centre of rotation [kg m]
  double mass = 0.0;                   ///< [kg]
};

/// Where a body stands in its tree, undeformed and with joint coordinates zero, seen from the
/// centre of rotation, which is the hub's origin on an axle, and the mass centre of the whole where
/// the hub flies: from this follows the tension that the hub's rotation and gravity put on it.
struct TensionPlace {
  Rotation R_HB;                       ///< from B to the hub frame H
  Position origin = Position::Zero();  ///< of B, from the centre of rotation, in B [m]
  /// From the root outward, in B; the last ends with the body's elements.
  std::vector<CarriedMass> carried;
};

}  // namespace spoke::space
