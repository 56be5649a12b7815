#pragma once

// The strains of one element of second order, and the forces and stiffness that follow
// (docs/formulation.md, section 16). With the nodes turned by Q = exp(th~) and De = u_2 - u_1,
//   y = Q_1^T (l + De),  dh = log(Q_1^T Q_2),  d0 = (y - l; dh),
//   d = d0 - (c(d0); a(d0)),                      U = 1/2 d^T K d,
// where c and a are those of models/space/element_second_order.h, and d is the d of
// calc_relative() to first order. A turn of the whole element leaves it as it is.

#include "engine/bodies/space/element_products.h"
#include "models/space/element_second_order.h"
#include "models/space/rotation_vector.h"

namespace spoke::space {

/// The section of a node against the body: Q = exp(th~) and its tangent map.
struct NodeTurn {
  Angular theta = Angular::Zero();
  Matrix3 Q = Matrix3::Identity();
  Matrix3 H = Matrix3::Identity();
  RotationCoefficients coefficients{};
};
NodeTurn calc_node_turn(const Angular& theta) noexcept;
/// Returns Q alone, to the bits of calc_node_turn().
Matrix3 calc_node_rotation(const Angular& theta) noexcept;

/// Coordinates of the two nodes of an element, and their derivatives.
inline constexpr int kBothNodes = 2 * kTwist;
using StrainMap = Eigen::Matrix<double, kTwist, kBothNodes>;
using NodesMatrix = Eigen::Matrix<double, kBothNodes, kBothNodes>;

/// Returns d alone at the coordinates q of both nodes, which are turned by the rotations `inner`
/// and `outer`, to the bits of ElementStrain::d() [m, rad].
Twist calc_element_strain(const BeamElement& element, const ElementSecondOrder& second,
                          const Matrix3& inner, const Matrix3& outer, const double* q) noexcept;

class ElementStrain {
 public:
  /// Calculates the strain at the coordinates q of both nodes, which are turned by `inner` and
  /// `outer`. Keeps references to all but element and q.
  ElementStrain(const BeamElement& element, const ElementSecondOrder& second, const NodeTurn& inner,
                const NodeTurn& outer, const double* q) noexcept;

  /// d: displacement and rotation of the outer node that strain the element, in B [m, rad].
  const Twist& d() const { return d_; }
  /// Returns the rate of d at velocities v of both nodes.
  Twist rate(const double* v) const noexcept;
  /// Subtracts D^T sigma, D = dd/dq, from the forces on both nodes.
  void subtract_force(const Twist& sigma, double* force) const noexcept;
  /// Returns D.
  StrainMap map() const noexcept;
  /// Returns D^T K D, K symmetric, and the derivatives of D^T sigma, sigma held.
  NodesMatrix tangent(const TwistMatrix& K, const Twist& sigma) const noexcept;

 private:
  [[gnu::always_inline]] inline void set_tangent(const TwistMatrix& K, const Twist& sigma,
                                                 NodesMatrix& nodes) const noexcept;

  const ElementSecondOrder& second_;
  const NodeTurn &inner_, &outer_;
  Position y_;
  Angular dh_;
  Matrix3 R_;  ///< Q_1^T Q_2
  Matrix3 J_;  ///< rate of dh per angular velocity of the outer node against the inner, in its axes
  TwistMatrix T_t_;  ///< transpose of dd/dd0
  Twist d_;
};

}  // namespace spoke::space
