#pragma once

// The place of a body in its tree, and the masses it carries: data that give the tension in it.

#include <vector>

#include "models/space/rotation.h"

namespace spoke::space {

/// The mass that elements carry besides that of their own body: all bodies that hang at nodes
/// further out.
struct CarriedMass {
  /// End of the elements it holds for, from the end of the entry before.
  int end = 0;
  /// First moment of that mass about the centre of rotation [kg m].
  Position moment = Position::Zero();
  double mass = 0.0;  ///< [kg]
};

/// The place of a body in its tree, undeformed and with joint coordinates zero, relative to the
/// centre of rotation: that is the hub's origin on an axle, and the mass centre of the whole where
/// the hub is free. The tension due to the hub's rotation and gravity follows from it.
struct TensionPlace {
  Rotation R_HB;                       ///< rotation from B to the hub frame H
  Position origin = Position::Zero();  ///< origin of B from the centre of rotation, in B [m]
  /// Carried masses from the root outward, in B; the last ends with the body's elements.
  std::vector<CarriedMass> carried;
};

}  // namespace spoke::space
