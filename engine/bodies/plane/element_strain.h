#pragma once

// The strains of one element of second order (docs/formulation.md, section 16): of displacements
// and rotations (u, v, psi) of its two nodes, with y = R(psi_1)^T (l + u_2 - u_1, v_2 - v_1),
//   e = y - (l, 0),  p = psi_2 - psi_1,
//   d = (e_x + 1/2 int v'^2, e_y - e_x e_y/l, p),   1/2 int v'^2 = (36 e_y^2 - 6 l e_y p + 4 l^2
//   p^2)/(60 l)
// the integral that of the cubic from node 1 along its tangent, and U = 1/2 d^T K d, with K of
// FlexibleBody::strain_stiffness. These are the strains of engine/bodies/space/element_strain.h; a
// turn of the whole element leaves them as they are.

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

inline ElementStrain::ElementStrain(double length, const NodesVector& q) noexcept
    : length_(length), R_(Rotation::from_angle(q[kRotation])) {
  const double l = length;
  y_ = R_.inverse() * Position(l + q[3] - q[0], q[4] - q[1]);
  const double e_x = y_.x() - l, e_y = y_.y(), p = q[5] - q[2];
  d_ = {e_x + e_y * (0.6 * e_y / l - 0.1 * p) + l * p * p / 15.0, e_y - e_x * e_y / l, p};
  T_ << 1.0, 1.2 * e_y / l - 0.1 * p, 2.0 * l * p / 15.0 - 0.1 * e_y,  //
      -e_y / l, 1.0 - e_x / l, 0.0,                                    //
      0.0, 0.0, 1.0;
}

inline StrainMap ElementStrain::map_to_e() const noexcept {
  const double c = R_.cosine, s = R_.sine;
  StrainMap map;
  map << -c, -s, y_.y(), c, s, 0.0,  //
      s, -c, -y_.x(), -s, c, 0.0,    //
      0.0, 0.0, -1.0, 0.0, 0.0, 1.0;
  return map;
}

inline NodesMatrix ElementStrain::geometric_stiffness(const Twist& sigma) const noexcept {
  // Second derivatives of d by (e, p).
  TwistMatrix forms;
  const double l = length_, across = -sigma[1] / l;
  forms << 0.0, across, 0.0,                        //
      across, 1.2 * sigma[0] / l, -0.1 * sigma[0],  //
      0.0, -0.1 * sigma[0], 2.0 * l * sigma[0] / 15.0;
  const StrainMap e = map_to_e();
  NodesMatrix K = e.transpose().lazyProduct(StrainMap(forms.lazyProduct(e)));
  // Second derivatives of (e, p) by the nodes: of the turn of the inner one alone.
  const Twist on_e = T_.transpose().lazyProduct(sigma);
  const Position F = on_e.head<kPosition>(), turned = R_ * quarter_turn(F);
  K(kRotation, kRotation) -= F.dot(y_);
  for (int c = 0; c < kPosition; ++c) {
    K(kRotation, kTwist + c) += turned[c];
    K(kTwist + c, kRotation) += turned[c];
    K(kRotation, c) -= turned[c];
    K(c, kRotation) -= turned[c];
  }
  return K;
}

}  // namespace spoke::plane
