// The exponential of rotation vectors with its derivatives; the logarithm, by way of the
// quaternion.

#include "models/space/rotation_vector.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "models/space/quaternion.h"

namespace spoke::space {
namespace {

/// Below a radian the closed forms lose more digits than eight terms of the series leave out.
constexpr int kTerms = 8;
using Series = std::array<double, kTerms>;

constexpr double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

/// The factors of t^2k in (t - sin t) / t^3.
constexpr Series make_d_series() {
  Series series{};
  double sign = 1.0;
  for (int k = 0; k < kTerms; ++k, sign = -sign)
    series[static_cast<std::size_t>(k)] = sign / factorial(2 * k + 3);
  return series;
}

/// Of (s - 2 c) / t^2, and of (c - 3 d) / t^2: -2 (k + 1) (-1)^k / (2 k + offset)! with the offsets
/// 4 and 5.
constexpr Series make_rate_series(int offset) {
  Series series{};
  double sign = -1.0;
  for (int k = 0; k < kTerms; ++k, sign = -sign)
    series[static_cast<std::size_t>(k)] = sign * 2.0 * (k + 1) / factorial(2 * k + offset);
  return series;
}

constexpr Series kD = make_d_series();
constexpr Series kCRate = make_rate_series(4);
constexpr Series kDRate = make_rate_series(5);

double sum_series(const Series& series, double x) {
  double sum = 0.0;
  for (std::size_t k = series.size(); k-- > 0;) sum = series[k] + x * sum;
  return sum;
}

/// 1 + a theta~ + b theta~^2.
Matrix3 calc_polynomial(double a, double b, const Angular& theta) {
  Matrix3 m = b * theta * theta.transpose() + skew(a * theta);
  m.diagonal().array() += 1.0 - b * theta.squaredNorm();  // theta~^2 = theta theta^T - t^2 1
  return m;
}

}  // namespace

RotationCoefficients calc_rotation_coefficients(double angle_squared) {
  const double x = angle_squared;
  if (x < 1.0) {
    const double d = sum_series(kD, x), d_rate = sum_series(kDRate, x);
    return {1.0 - x * d, 3.0 * d + x * d_rate, d, sum_series(kCRate, x), d_rate};
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
  const double stretch = theta.dot(rate);  // t t'
  const Angular once = cross(theta, rate);
  const Angular convective =
      k.c_rate * stretch * once + k.d_rate * stretch * cross(theta, once) + k.d * cross(rate, once);
  return {{calc_polynomial(k.s, k.c, theta)}, H, H.lazyProduct(rate), convective};
}

Angular logarithm(const Rotation& R) { return logarithm(make_quaternion(R)); }

}  // namespace spoke::space
