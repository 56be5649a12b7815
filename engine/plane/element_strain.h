#pragma once

// The strains of one element of second order (docs/formulation.md, section 16): of displacements
// and rotations (u, v, psi) of its two nodes, with y = R(psi_1)^T (l + u_2 - u_1, v_2 - v_1),
//   e = y - (l, 0),  p = psi_2 - psi_1,
//   d = (e_x + 1/2 int v'^2, e_y - e_x e_y/l, p),   1/2 int v'^2 = (36 e_y^2 - 6 l e_y p + 4 l^2
//   p^2)/(60 l)
// the integral that of the cubic from node 1 along its tangent, and U = 1/2 d^T K d, with K of
// FlexibleBody::strain_stiffness. These are the strains of engine/space/element_strain.h; a turn of
// the whole element leaves them as they are.

#include <Eigen/Core>

#include "models/plane/plane.h"

namespace spoke::plane {

/// Coordinates of both nodes, inner before outer, and derivatives by them.
inline constexpr int kBothNodes = 2 * kTwist;
using NodesVector = Eigen::Matrix<double, kBothNodes, 1>;
using StrainMap = Eigen::Matrix<double, kTwist, kBothNodes>;
using NodesMatrix = Eigen::Matrix<double, kBothNodes, kBothNodes>;

class ElementStrain {
 public:
  /// Calculates the strain of an element of a length [m] at coordinates of its nodes.
  ElementStrain(double length, const NodesVector& q) noexcept;

  /// Displacement and rotation of the outer node that strain the element, along and across the
  /// inner section [m, rad].
  const Twist& d() const { return d_; }
  /// Returns D = dd/dq.
  StrainMap map() const noexcept { return T_.lazyProduct(map_to_e()); }
  /// Returns the derivatives of D^T sigma, sigma held.
  NodesMatrix geometric_stiffness(const Twist& sigma) const noexcept;

 private:
  StrainMap map_to_e() const noexcept;

  double length_;
  Rotation R_;  ///< of the inner section against the body
  Position y_;  ///< from the inner to the outer node, along and across the inner section [m]
  Twist d_;
  TwistMatrix T_;  ///< derivatives of d by (e, p)
};

}  // namespace spoke::plane
