#pragma once

// The coefficients of rotation vectors (rotation_vector.h) as series in x = t^2. Below a radian the
// closed forms lose more digits than eight terms of the series leave out.

#include <array>
#include <cstddef>

namespace spoke::space {

inline constexpr std::size_t kRotationTerms = 8;
using RotationSeries = std::array<double, kRotationTerms>;

namespace detail {

constexpr double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

constexpr RotationSeries make_d_series() {
  RotationSeries series{};
  double sign = 1.0;
  for (int k = 0; k < static_cast<int>(kRotationTerms); ++k, sign = -sign)
    series[static_cast<std::size_t>(k)] = sign / factorial(2 * k + 3);
  return series;
}

/// -2 (k + 1) (-1)^k / (2 k + offset)!.
constexpr RotationSeries make_rate_series(int offset) {
  RotationSeries series{};
  double sign = -1.0;
  for (int k = 0; k < static_cast<int>(kRotationTerms); ++k, sign = -sign)
    series[static_cast<std::size_t>(k)] = sign * 2.0 * (k + 1) / factorial(2 * k + offset);
  return series;
}

}  // namespace detail

/// The factors of x^k in d = (t - sin t) / t^3, in c_rate = (s - 2 c) / t^2, and in d_rate =
/// (c - 3 d) / t^2.
inline constexpr RotationSeries kDSeries = detail::make_d_series();
inline constexpr RotationSeries kCRateSeries = detail::make_rate_series(4);
inline constexpr RotationSeries kDRateSeries = detail::make_rate_series(5);

/// Sums a series for one x, or for several side by side.
template <class Value>
[[gnu::always_inline]] inline Value sum_series(const RotationSeries& series, const Value& x) {
  Value sum{};
  for (std::size_t k = series.size(); k-- > 0;) sum = series[k] + x * sum;
  return sum;
}

}  // namespace spoke::space
