// Quaternions from and to rotations.

#include "models/space/quaternion.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace spoke::space {

Quaternion normalize(const Quaternion& Q) { return 1.0 / std::sqrt(Q.squared_norm()) * Q; }

Rotation make_rotation(const Quaternion& Q) {
  // A simulation that diverges may hold numbers that are not finite, which this assertion lets
  // pass.
  assert(!(std::abs(Q.w * Q.w + Q.v.squaredNorm() - 1.0) > 1e-6) && "of unit length");
  Matrix3 m = 2.0 * (Q.v * Q.v.transpose() + skew(Q.w * Q.v));
  m.diagonal().array() += Q.w * Q.w - Q.v.squaredNorm();
  return {m};
}

Quaternion make_quaternion(const Rotation& R) {
  // The largest of the four squares comes first, so that no division is by a small number (Shepperd
  // 1978).
  const Matrix3& m = R.axes;
  const double trace = m.trace();
  int i = 0;
  const double largest = m.diagonal().maxCoeff(&i);
  Quaternion Q;
  if (trace >= largest) {
    Q.w = 1.0 + trace;
    Q.v = {m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
  } else {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Q.w = m(k, j) - m(j, k);
    Q.v[i] = 1.0 + 2.0 * largest - trace;
    Q.v[j] = m(i, j) + m(j, i);
    Q.v[k] = m(i, k) + m(k, i);
    if (Q.w < 0.0) Q = {-Q.w, -Q.v};
  }
  return normalize(Q);
}

Quaternion make_quaternion(const Angular& theta) {
  const double angle = theta.norm();
  const double factor = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5;
  return {std::cos(0.5 * angle), factor * theta};
}

Angular logarithm(const Quaternion& Q) {
  const double sine = Q.v.norm();
  if (sine == 0.0) return Angular::Zero();
  const double sign = Q.w < 0.0 ? -1.0 : 1.0;
  return sign * 2.0 * std::atan2(sine, sign * Q.w) / sine * Q.v;
}

Quaternion turn(const Quaternion& Q, const Angular& D, TurnFrame frame) {
  const Quaternion by = make_quaternion(D);
  return frame == TurnFrame::child ? Q * by : by * Q;
}

Quaternion calc_rate(const Quaternion& Q, const Angular& w) { return Q * Quaternion{0.0, 0.5 * w}; }

Quaternion calc_rate(const Angular& w, const Quaternion& Q) { return Quaternion{0.0, 0.5 * w} * Q; }

}  // namespace spoke::space
