// Series after a reduction of the argument, and Wichura's rational functions.

#include "program/study/portable_math.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

namespace spoke::study {
namespace {

constexpr double kLn2High = 0x1.62e42fefa38p-1;   // in 41 bits, so that its multiples are exact
constexpr double kLn2Low = 0x1.ef35793c7673p-45;  // the rest of ln 2
constexpr double kSqrtHalf = 0.70710678118654752440;

/// Evaluates the polynomial with these coefficients, the constant one first.
double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

// Numerators and denominators of AS 241: for |p - 1/2| up to 0.425, then for sqrt(-log p) up to 5
// and beyond.
constexpr std::array kA = {3.3871328727963666080e0,  1.3314166789178437745e+2,
                           1.9715909503065514427e+3, 1.3731693765509461125e+4,
                           4.5921953931549871457e+4, 6.7265770927008700853e+4,
                           3.3430575583588128105e+4, 2.5090809287301226727e+3};
constexpr std::array kB = {1.0,
                           4.2313330701600911252e+1,
                           6.8718700749205790830e+2,
                           5.3941960214247511077e+3,
                           2.1213794301586595867e+4,
                           3.9307895800092710610e+4,
                           2.8729085735721942674e+4,
                           5.2264952788528545610e+3};
constexpr std::array kC = {1.42343711074968357734e0,  4.63033784615654529590e0,
                           5.76949722146069140550e0,  3.64784832476320460504e0,
                           1.27045825245236838258e0,  2.41780725177450611770e-1,
                           2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr std::array kD = {1.0,
                           2.05319162663775882187e0,
                           1.67638483018380384940e0,
                           6.89767334985100004550e-1,
                           1.48103976427480074590e-1,
                           1.51986665636164571966e-2,
                           5.47593808499534494600e-4,
                           1.05075007164441684324e-9};
constexpr std::array kE = {6.65790464350110377720e0,  5.46378491116411436990e0,
                           1.78482653991729133580e0,  2.96560571828504891230e-1,
                           2.65321895265761230930e-2, 1.24266094738807843860e-3,
                           2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr std::array kF = {1.0,
                           5.99832206555887937690e-1,
                           1.36929880922735805310e-1,
                           1.48753612908506148525e-2,
                           7.86869131745613259100e-4,
                           1.84631831751005468180e-5,
                           1.42151175831644588870e-7,
                           2.04426310338993978564e-15};

}  // namespace

double portable_log(double x) {
  assert(x > 0.0);
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact
  if (m < kSqrtHalf) {
    m *= 2.0;
    --exponent;
  }
  // log m = 2 (s + s^3/3 + s^5/5 + ...), |s| < 0.172
  const double s = (m - 1.0) / (m + 1.0), square = s * s;
  double sum = 0.0;
  for (int n = 23; n >= 3; n -= 2) sum = (sum + 1.0 / n) * square;
  const double k = exponent;
  return k * kLn2High + (2.0 * s + (2.0 * s * sum + k * kLn2Low));
}

double portable_exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 710.0) return std::numeric_limits<double>::infinity();
  if (x < -746.0) return 0.0;
  const double k = std::floor(x / (kLn2High + kLn2Low) + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| < 0.35
  double sum = 0.0;
  for (int n = 15; n >= 2; --n) sum = (sum + 1.0) * (r / n);
  return std::ldexp(1.0 + (r + r * sum), static_cast<int>(k));
}

double portable_power(double base, double exponent) {
  if (exponent == std::floor(exponent) && std::abs(exponent) <= 64.0) {
    double power = 1.0, square = base;
    for (int n = static_cast<int>(std::abs(exponent)); n > 0; n /= 2) {
      if (n % 2 == 1) power *= square;
      square *= square;
    }
    return exponent < 0.0 ? 1.0 / power : power;
  }
  if (base == 0.0) return exponent > 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  if (!(base > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return portable_exp(exponent * portable_log(base));
}

double normal_quantile(double p) {
  assert(p > 0.0 && p < 1.0);
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(kA, r) / polynomial(kB, r);
  }
  const double r = std::sqrt(-portable_log(q < 0.0 ? p : 1.0 - p));
  const double x = r <= 5.0 ? polynomial(kC, r - 1.6) / polynomial(kD, r - 1.6)
                            : polynomial(kE, r - 5.0) / polynomial(kF, r - 5.0);
  return q < 0.0 ? -x : x;
}

}  // namespace spoke::study
