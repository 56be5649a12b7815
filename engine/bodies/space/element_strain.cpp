// Goes forward from the nodes to the strain, and back from the forces of strain to the nodes.

#include "engine/bodies/space/element_strain.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "models/space/rotation_series.h"
#include "models/space/twist_columns.h"
#include "models/support/wide_kernels.h"

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
Matrix3 differ_tangent(const NodeTurn& turn, const Angular& m) {
  const RotationCoefficients& k = turn.coefficients;
  return differ_polynomial(k.c, k.d, k.c_rate, k.d_rate, turn.theta, m);
}
/// Returns the derivatives of J(dh)^T m by dh.
Matrix3 differ_logarithm_rate(const Angular& dh, const Angular& m) {
  const LogarithmCoefficients at = calc_logarithm_coefficients(dh.squaredNorm());
  return differ_polynomial(-0.5, at.k, 0.0, at.k_rate, dh, m);
}

/// asin(s)/s as a series in s^2.
constexpr std::size_t kArcTerms = 14;
constexpr std::array<double, kArcTerms> make_arc_series() {
  std::array<double, kArcTerms> series{};
  double binomial = 1.0;  // (2k)!/(4^k k!^2)
  for (std::size_t k = 0; k < kArcTerms; ++k) {
    const auto n = static_cast<double>(k);
    series[k] = binomial / (2.0 * n + 1.0);
    binomial *= (2.0 * n + 1.0) / (2.0 * n + 2.0);
  }
  return series;
}
constexpr auto kArcSeries = make_arc_series();

/// Returns log(R), for the small angles between the ends of an element without a square root.
Angular calc_logarithm(const Matrix3& R) {
  const Angular v = 0.5 * Angular(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double x = v.squaredNorm();
  if (!(x < 0.06) || R.trace() < 2.0) return logarithm(Rotation{R});
  double sum = 0.0;
  for (std::size_t k = kArcTerms; k-- > 0;) sum = kArcSeries[k] + x * sum;
  return sum * v;
}

/// Subtracts from d what the forms take off it. `set_row(i, forms[i] d0)` gets each product.
template <class SetRow>
[[gnu::always_inline]] inline void subtract_forms(const ElementSecondOrder::Forms& forms,
                                                  const Twist& d0, int first, Twist& d,
                                                  const SetRow& set_row) {
  for (int i = 0; i < 3; ++i) {
    const Twist row = multiply(forms[static_cast<std::size_t>(i)], d0);
    d[first + i] -= 0.5 * row.dot(d0);
    set_row(i, row);
  }
}

/// Sets the rows of dd/dd0, -forms d0 but for the identity, as columns, and subtracts what they
/// take off d.
void set_rows(const ElementSecondOrder::Forms& forms, const Twist& d0, int first, TwistMatrix& T_t,
              Twist& d) {
  subtract_forms(forms, d0, first, d, [&](int i, const Twist& row) {
    T_t.col(first + i) = -row;
    T_t(first + i, first + i) += 1.0;
  });
}

/// 1 + a theta~ + b theta~^2.
Matrix3 calc_polynomial(double a, double b, const Angular& theta) {
  Matrix3 m = b * theta * theta.transpose() + skew(a * theta);
  m.diagonal().array() += 1.0 - b * theta.squaredNorm();
  return m;
}

Matrix3 symmetric(const Matrix3& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

NodeTurn calc_node_turn(const Angular& theta) noexcept {
  NodeTurn turn;
  turn.theta = theta;
  turn.coefficients = calc_rotation_coefficients(theta.squaredNorm());
  const RotationCoefficients& k = turn.coefficients;
  turn.Q = calc_polynomial(k.s, k.c, theta);
  turn.H = calc_polynomial(k.c, k.d, theta);
  return turn;
}

Matrix3 calc_node_rotation(const Angular& theta) noexcept {
  const RotationCoefficients k = calc_rotation_coefficients(theta.squaredNorm());
  return calc_polynomial(k.s, k.c, theta);
}

Twist calc_element_strain(const BeamElement& element, const ElementSecondOrder& second,
                          const Matrix3& inner, const Matrix3& outer, const double* q) noexcept {
  return run_large_kernel([&] {
    const Position y = inner.transpose().lazyProduct(element.chord + Node(q + kTwist) - Node(q));
    const Angular dh = calc_logarithm(inner.transpose().lazyProduct(outer));
    const Twist d0 = make_twist(y - element.chord, dh);
    Twist d = d0;
    const auto leave = [](int, const Twist&) {};
    subtract_forms(second.place, d0, 0, d, leave);
    subtract_forms(second.rotation, d0, kRotation, d, leave);
    return d;
  });
}

ElementStrain::ElementStrain(const BeamElement& element, const ElementSecondOrder& second,
                             const NodeTurn& inner, const NodeTurn& outer, const double* q) noexcept
    : second_(second), inner_(inner), outer_(outer) {
  run_large_kernel([&] {
    y_ = inner.Q.transpose().lazyProduct(element.chord + Node(q + kTwist) - Node(q));
    R_ = inner.Q.transpose().lazyProduct(outer.Q);
    dh_ = calc_logarithm(R_);
    J_ = calc_logarithm_rate(dh_);
    const Twist d0 = make_twist(y_ - element.chord, dh_);
    d_ = d0;
    set_rows(second.place, d0, 0, T_t_, d_);
    set_rows(second.rotation, d0, kRotation, T_t_, d_);
  });
}

Twist ElementStrain::rate(const double* v) const noexcept {
  const Angular inner = inner_.H.transpose().lazyProduct(Node(v + kRotation));
  const Angular outer = outer_.H.transpose().lazyProduct(Node(v + kTwist + kRotation));
  const Position De = Node(v + kTwist) - Node(v);
  const Position y = inner_.Q.transpose().lazyProduct(De) + cross(y_, inner);
  const Angular w = outer - R_.transpose().lazyProduct(inner);
  return T_t_.transpose().lazyProduct(make_twist(y, J_.lazyProduct(w)));
}

void ElementStrain::subtract_force(const Twist& sigma, double* force) const noexcept {
  const Twist g = multiply(T_t_, sigma);
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

StrainMap ElementStrain::map() const noexcept {
  StrainMap D0 = StrainMap::Zero();
  const Matrix3 inner = inner_.H.transpose(), outer = outer_.H.transpose();
  D0.block<3, 3>(0, 0) = -inner_.Q.transpose();
  D0.block<3, 3>(0, kTwist) = inner_.Q.transpose();
  D0.block<3, 3>(0, kRotation) = skew(y_).lazyProduct(inner);
  D0.block<3, 3>(kRotation, kRotation) =
      -J_.lazyProduct(Matrix3(R_.transpose().lazyProduct(inner)));
  D0.block<3, 3>(kRotation, kTwist + kRotation) = J_.lazyProduct(outer);
  return T_t_.transpose().lazyProduct(D0);
}

NodesMatrix ElementStrain::tangent(const TwistMatrix& K, const Twist& sigma) const noexcept {
  NodesMatrix nodes;
  run_large_kernel([&] { set_tangent(K, sigma, nodes); });
  return nodes;
}

// With x = (y', w_1, w_2), the angular velocities in the axes of their nodes:
//   d0' = A x,  A = [1, y~, 0; 0, -J R^T, J];      D0^T g = (F; F x y - R m; m), m = J^T M, g = (F;
//   M).
// A^T (T^T K T - forms) A is by the strain, what is left by the directions of these forces.
void ElementStrain::set_tangent(const TwistMatrix& K, const Twist& sigma,
                                NodesMatrix& nodes) const noexcept {
  TwistMatrix by_d0 = multiply_transposed(multiply(T_t_, K), T_t_);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    by_d0 -= sigma[at] * second_.place[i] + sigma[kRotation + at] * second_.rotation[i];
  }
  const Matrix3 tt = by_d0.topLeftCorner<3, 3>(), rt = by_d0.bottomLeftCorner<3, 3>(),
                rr = by_d0.bottomRightCorner<3, 3>();
  const Twist g = multiply(T_t_, sigma);
  const Position F = g.head<3>();
  const Angular M = g.tail<3>(), m = J_.transpose().lazyProduct(M);
  const Matrix3 y = skew(y_), P = J_.lazyProduct(R_.transpose());
  const Matrix3 slope = differ_logarithm_rate(dh_, M), slope_P = slope.lazyProduct(P);
  const Matrix3 on_place = tt.lazyProduct(y) - rt.transpose().lazyProduct(P);
  const Matrix3 on_turn = rt.lazyProduct(y) - rr.lazyProduct(P);
  const Matrix3 J_t = J_.transpose();
  const Matrix3 inner_place = on_place.transpose() + skew(F);
  const Matrix3 outer_place = J_t.lazyProduct(rt);
  const Matrix3 inner = skew(F).lazyProduct(y) - y.lazyProduct(on_place) -
                        P.transpose().lazyProduct(on_turn) +
                        R_.lazyProduct(Matrix3(slope_P - skew(m).lazyProduct(R_.transpose())));
  const Matrix3 outer_inner = J_t.lazyProduct(on_turn) - slope_P;
  const Matrix3 outer = J_t.lazyProduct(rr).lazyProduct(J_) + slope.lazyProduct(J_);

  const Matrix3 &Q = inner_.Q, Q_t = Q.transpose(), &H = inner_.H, &G = outer_.H;
  const Matrix3 uu = Q.lazyProduct(tt).lazyProduct(Q_t);
  const Matrix3 inner_u = H.lazyProduct(inner_place).lazyProduct(Q_t);
  const Matrix3 outer_u = G.lazyProduct(outer_place).lazyProduct(Q_t);
  const Position n = cross(F, y_) - R_.lazyProduct(m);
  constexpr int i = kRotation, u = kTwist, o = kTwist + kRotation;
  nodes.block<3, 3>(0, 0) = uu;
  nodes.block<3, 3>(u, 0) = -uu;
  nodes.block<3, 3>(u, u) = uu;
  nodes.block<3, 3>(i, 0) = -inner_u;
  nodes.block<3, 3>(u, i) = inner_u.transpose();
  nodes.block<3, 3>(o, 0) = -outer_u;
  nodes.block<3, 3>(o, u) = outer_u;
  nodes.block<3, 3>(i, i) =
      symmetric(H.lazyProduct(inner).lazyProduct(H.transpose()) + differ_tangent(inner_, n));
  nodes.block<3, 3>(o, i) = G.lazyProduct(outer_inner).lazyProduct(H.transpose());
  nodes.block<3, 3>(o, o) =
      symmetric(G.lazyProduct(outer).lazyProduct(G.transpose()) + differ_tangent(outer_, m));
  nodes.block<3, 3>(0, u) = -uu;
  nodes.block<3, 3>(0, i) = -inner_u.transpose();
  nodes.block<3, 3>(i, u) = inner_u;
  nodes.block<3, 3>(0, o) = -outer_u.transpose();
  nodes.block<3, 3>(u, o) = outer_u.transpose();
  nodes.block<3, 3>(i, o) = nodes.block<3, 3>(o, i).transpose();
}

}  // namespace spoke::space
