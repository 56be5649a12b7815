#pragma once

// The place of a body in its tree, and the masses it carries: data that give the tension in it.

#include <Eigen/Core>
#include <array>
#include <memory>
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

/// Geometric stiffness of a solid in its tree, by what all outboard of it adds: r x r of a reduced
/// one; of a nodal one values in the places of those of m, one column.
struct SolidTension {
  std::array<Eigen::MatrixXd, 6> spin;  ///< K_G by the monomials of the hub's angular velocity in B
  std::array<Eigen::MatrixXd, 3> gravity;  ///< K_G by a field along x, y, z of B
};

/// The place of a body in its tree, undeformed and with joint coordinates zero, relative to the
/// centre of rotation: that is the hub's origin on an axle, and the mass centre of the whole where
/// the hub is free. The tension due to the hub's rotation and gravity follows from it.
struct TensionPlace {
  Rotation R_HB;                       ///< rotation from B to the hub frame H
  Position origin = Position::Zero();  ///< origin of B from the centre of rotation, in B [m]
  /// Carried masses from the root outward, in B; the last ends with the body's elements.
  std::vector<CarriedMass> carried;
  std::shared_ptr<const SolidTension> solid{};  ///< of a solid, which has it in place of `carried`
};

}  // namespace spoke::space
