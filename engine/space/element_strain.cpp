// Goes forward from the nodes to the strain, and back from the forces of strain to the nodes.

#include "engine/space/element_strain.h"

#include <cmath>

namespace spoke::space {
namespace {

using Node = Eigen::Map<const Position>;

/// k = (1 - (t/2) cot(t/2)) / t^2 of an angle t, and k'/t.
struct LogarithmCoefficients {
  double k, k_rate;
};
LogarithmCoefficients calc_logarithm_coefficients(double x) {
  if (x < 0.04)
    return {1.0 / 12.0 + x * (1.0 / 720.0 + x * (1.0 / 30240.0 + x / 1209600.0)),
            1.0 / 360.0 + x * (1.0 / 7560.0 + x * (1.0 / 201600.0 + x / 5987520.0))};
  const double half = 0.5 * std::sqrt(x), cotangent = 1.0 / std::tan(half);
  const double k = (1.0 - half * cotangent) / x;
  // d/dt of (t/2) cot(t/2) is cot(t/2)/2 - t/4 (1 + cot^2(t/2)).
  const double slope = -0.5 * cotangent + 0.5 * half * (1.0 + cotangent * cotangent);
  return {k, (slope / (2.0 * half) - 2.0 * k) / x};
}

/// Returns J with dh' = J w, w the angular velocity of R = exp(dh~) in its own axes: 1 + dh~/2 + k
/// dh~^2.
Matrix3 calc_logarithm_rate(const Angular& dh) {
  const double x = dh.squaredNorm(), k = calc_logarithm_coefficients(x).k;
  Matrix3 J = k * dh * dh.transpose() + skew(0.5 * dh);
  J.diagonal().array() += 1.0 - k * x;
  return J;
}

/// Returns the derivatives of m + once a x m + twice a x (a x m) by a, m held; the rates are those
/// of the factors by a.a/2.
Matrix3 differ_polynomial(double once, double twice, double once_rate, double twice_rate,
                          const Angular& a, const Angular& m) {
  const Angular a_m = cross(a, m);
  Matrix3 slope = twice * (a * m.transpose() - 2.0 * m * a.transpose()) - skew(once * m);
  slope.diagonal().array() += twice * a.dot(m);
  slope += (once_rate * a_m + twice_rate * cross(a, a_m)) * a.transpose();
  return slope;
}

/// Returns the derivatives of H(theta) m by theta.
Matrix3 differ_tangent(const Angular& theta, const Angular& m) {
  const RotationCoefficients k = calc_rotation_coefficients(theta.squaredNorm());
  return differ_polynomial(k.c, k.d, k.c_rate, k.d_rate, theta, m);
}
/// Returns the derivatives of J(dh)^T m by dh.
Matrix3 differ_logarithm_rate(const Angular& dh, const Angular& m) {
  const LogarithmCoefficients at = calc_logarithm_coefficients(dh.squaredNorm());
  return differ_polynomial(-0.5, at.k, 0.0, at.k_rate, dh, m);
}

/// Sets the rows of -dF/dd0, by half: T's difference from the identity.
void set_rows(const ElementSecondOrder::Forms& forms, const Twist& d0, int first, TwistMatrix& T,
              Twist& d) {
  for (int i = 0; i < 3; ++i) {
    const Twist row = forms[static_cast<std::size_t>(i)].lazyProduct(d0);
    d[first + i] -= 0.5 * row.dot(d0);
    T.row(first + i) -= row.transpose();
  }
}

}  // namespace

NodeTurn calc_node_turn(const Angular& theta) noexcept {
  const RotationVectorMotion motion = calc_rotation_vector_motion(theta, Angular::Zero());
  return {theta, motion.R.axes, motion.H};
}

ElementStrain::ElementStrain(const BeamElement& element, const ElementSecondOrder& second,
                             const NodeTurn& inner, const NodeTurn& outer, const double* q) noexcept
    : second_(second), inner_(inner), outer_(outer) {
  y_ = inner.Q.transpose().lazyProduct(element.chord + Node(q + kTwist) - Node(q));
  R_ = inner.Q.transpose().lazyProduct(outer.Q);
  dh_ = logarithm(Rotation{R_});
  J_ = calc_logarithm_rate(dh_);
  const Twist d0 = make_twist(y_ - element.chord, dh_);
  d_ = d0;
  T_.setIdentity();
  set_rows(second.place, d0, 0, T_, d_);
  set_rows(second.rotation, d0, kRotation, T_, d_);
}

Twist ElementStrain::rate(const double* v) const noexcept {
  const Angular inner = inner_.H.transpose().lazyProduct(Node(v + kRotation));
  const Angular outer = outer_.H.transpose().lazyProduct(Node(v + kTwist + kRotation));
  const Position De = Node(v + kTwist) - Node(v);
  const Position y = inner_.Q.transpose().lazyProduct(De) + cross(y_, inner);
  const Angular w = outer - R_.transpose().lazyProduct(inner);
  return T_.lazyProduct(make_twist(y, J_.lazyProduct(w)));
}

void ElementStrain::subtract_force(const Twist& sigma, double* force) const noexcept {
  const Twist g = T_.transpose().lazyProduct(sigma);
  const Position F = g.head<3>();
  const Angular m = J_.transpose().lazyProduct(g.tail<3>());
  const Position on_outer = inner_.Q.lazyProduct(F);
  const Angular outer = outer_.H.lazyProduct(m);
  const Angular inner = inner_.H.lazyProduct(cross(F, y_) - R_.lazyProduct(m));
  for (int i = 0; i < 3; ++i) {
    force[i] += on_outer[i];
    force[kRotation + i] -= inner[i];
    force[kTwist + i] -= on_outer[i];
    force[kTwist + kRotation + i] -= outer[i];
  }
}

StrainMap ElementStrain::map_to_d0() const noexcept {
  StrainMap D0 = StrainMap::Zero();
  const Matrix3 inner = inner_.H.transpose(), outer = outer_.H.transpose();
  D0.block<3, 3>(0, 0) = -inner_.Q.transpose();
  D0.block<3, 3>(0, kTwist) = inner_.Q.transpose();
  D0.block<3, 3>(0, kRotation) = skew(y_).lazyProduct(inner);
  D0.block<3, 3>(kRotation, kRotation) =
      -J_.lazyProduct(Matrix3(R_.transpose().lazyProduct(inner)));
  D0.block<3, 3>(kRotation, kTwist + kRotation) = J_.lazyProduct(outer);
  return D0;
}

StrainMap ElementStrain::map() const noexcept { return T_.lazyProduct(map_to_d0()); }

NodesMatrix ElementStrain::geometric_stiffness(const Twist& sigma) const noexcept {
  const StrainMap D0 = map_to_d0();
  // By T: D0^T (dT^T/dq sigma).
  Matrix6 forms = Matrix6::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    forms += sigma[at] * second_.place[i] + sigma[kRotation + at] * second_.rotation[i];
  }
  const StrainMap by_forms = forms.lazyProduct(D0);
  NodesMatrix K = -D0.transpose().lazyProduct(by_forms);
  // By D0, with g = T^T sigma held: the rows of subtract_force(), one after the other.
  using Rows = Eigen::Matrix<double, 3, kBothNodes>;
  const Twist g = T_.transpose().lazyProduct(sigma);
  const Position F = g.head<3>();
  const Angular M = g.tail<3>(), m = J_.transpose().lazyProduct(M);
  Rows inner = Rows::Zero(), w = Rows::Zero();  // angular velocities: inner node, outer less inner
  inner.middleCols<3>(kRotation) = inner_.H.transpose();
  w.middleCols<3>(kRotation) = -R_.transpose().lazyProduct(inner_.H.transpose());
  w.middleCols<3>(kTwist + kRotation) = outer_.H.transpose();
  const Rows m_slope = differ_logarithm_rate(dh_, M).lazyProduct(D0.bottomRows<3>());
  const Rows F_slope = Matrix3(inner_.Q.lazyProduct(skew(-F))).lazyProduct(inner);
  K.middleRows<3>(0) -= F_slope;
  K.middleRows<3>(kTwist) += F_slope;
  K.middleRows<3>(kTwist + kRotation) += outer_.H.lazyProduct(m_slope);
  K.block<3, 3>(kTwist + kRotation, kTwist + kRotation) += differ_tangent(outer_.theta, m);
  const Angular n = cross(F, y_) - R_.lazyProduct(m);
  Rows n_slope = skew(F).lazyProduct(D0.topRows<3>());
  n_slope += R_.lazyProduct(Rows(skew(m).lazyProduct(w) - m_slope));
  K.middleRows<3>(kRotation) += inner_.H.lazyProduct(n_slope);
  K.block<3, 3>(kRotation, kRotation) += differ_tangent(inner_.theta, n);
  return 0.5 * (K + K.transpose());
}

}  // namespace spoke::space
