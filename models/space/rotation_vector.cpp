// The exponential of rotation vectors with its derivatives; the logarithm, by way of the
// quaternion.

#include "models/space/rotation_vector.h"

#include <cassert>
#include <cmath>

#include "models/space/quaternion.h"
#include "models/space/rotation_series.h"

namespace spoke::space {
namespace {

/// 1 + a theta~ + b theta~^2.
Matrix3 calc_polynomial(double a, double b, const Angular& theta) {
  Matrix3 m = b * theta * theta.transpose() + skew(a * theta);
  m.diagonal().array() += 1.0 - b * theta.squaredNorm();  // theta~^2 = theta theta^T - t^2 1
  return m;
}

}  // namespace

RotationCoefficients calc_rotation_coefficients(double angle_squared) {
  assert(!(angle_squared < 0.0));
  const double x = angle_squared;
  if (x < 1.0) {
    const double d = sum_series(kDSeries, x), d_rate = sum_series(kDRateSeries, x);
    return {1.0 - x * d, 3.0 * d + x * d_rate, d, sum_series(kCRateSeries, x), d_rate};
  }
  const double t = std::sqrt(x);
  const double s = std::sin(t) / t;
  const double c = (1.0 - std::cos(t)) / x;
  const double d = (1.0 - s) / x;
  return {s, c, d, (s - 2.0 * c) / x, (c - 3.0 * d) / x};
}

Rotation exponential(const Angular& theta) {
  const RotationCoefficients k = calc_rotation_coefficients(theta.squaredNorm());
  return {calc_polynomial(k.s, k.c, theta)};
}

Matrix3 calc_tangent(const Angular& theta) {
  const RotationCoefficients k = calc_rotation_coefficients(theta.squaredNorm());
  return calc_polynomial(k.c, k.d, theta);
}

RotationVectorMotion calc_rotation_vector_motion(const Angular& theta, const Angular& rate) {
  const RotationCoefficients k = calc_rotation_coefficients(theta.squaredNorm());
  const Matrix3 H = calc_polynomial(k.c, k.d, theta);
  const double stretch = theta.dot(rate);  // t t', with t' the rate of t = |theta|
  const Angular once = cross(theta, rate);
  const Angular convective =
      k.c_rate * stretch * once + k.d_rate * stretch * cross(theta, once) + k.d * cross(rate, once);
  return {{calc_polynomial(k.s, k.c, theta)}, H, H.lazyProduct(rate), convective};
}

Angular logarithm(const Rotation& R) { return logarithm(make_quaternion(R)); }

}  // namespace spoke::space
