// One pass over the series for each factor of their length.

#include "models/air/inverse_fourier.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "models/support/wide_kernels.h"

namespace spoke::air {
namespace {

using Place = EightSeries::Place;
using Root = std::complex<double>;

[[gnu::always_inline]] inline Place operator+(const Place& a, const Place& b) noexcept {
  return {a.first + b.first, a.last + b.last};
}
[[gnu::always_inline]] inline Place operator-(const Place& a, const Place& b) noexcept {
  return {a.first - b.first, a.last - b.last};
}
[[gnu::always_inline]] inline Place operator*(double factor, const Place& a) noexcept {
  return {factor * a.first, factor * a.last};
}
[[gnu::always_inline]] inline Place turn(const Place& a) noexcept { return {-a.last, a.first}; }
[[gnu::always_inline]] inline Place multiply(const Place& a, double re, double im) noexcept {
  return {re * a.first - im * a.last, re * a.last + im * a.first};
}

// Transforms of a few values, in place.

[[gnu::always_inline]] inline void transform(Place (&a)[2]) noexcept {
  const Place difference = a[0] - a[1];
  a[0] = a[0] + a[1];
  a[1] = difference;
}

[[gnu::always_inline]] inline void transform(Place (&a)[3]) noexcept {
  constexpr double sine = 0.5 * std::numbers::sqrt3;
  const Place sum = a[1] + a[2];
  const Place across = turn(sine * (a[1] - a[2]));
  const Place middle = a[0] - 0.5 * sum;
  a[0] = a[0] + sum;
  a[1] = middle + across;
  a[2] = middle - across;
}

[[gnu::always_inline]] inline void transform(Place (&a)[4]) noexcept {
  const Place even = a[0] + a[2], odd = a[1] + a[3];
  const Place even_across = a[0] - a[2], odd_across = turn(a[1] - a[3]);
  a[0] = even + odd;
  a[1] = even_across + odd_across;
  a[2] = even - odd;
  a[3] = even_across - odd_across;
}

[[gnu::always_inline]] inline void transform(Place (&a)[5]) noexcept {
  constexpr double cosine_1 = 0.30901699437494742410, sine_1 = 0.95105651629515357212;
  constexpr double cosine_2 = -0.80901699437494742410, sine_2 = 0.58778525229247312917;
  const Place outer = a[1] + a[4], inner = a[2] + a[3];
  const Place outer_across = a[1] - a[4], inner_across = a[2] - a[3];
  const Place middle_1 = a[0] + cosine_1 * outer + cosine_2 * inner;
  const Place middle_2 = a[0] + cosine_2 * outer + cosine_1 * inner;
  const Place across_1 = turn(sine_1 * outer_across + sine_2 * inner_across);
  const Place across_2 = turn(sine_2 * outer_across - sine_1 * inner_across);
  a[0] = a[0] + outer + inner;
  a[1] = middle_1 + across_1;
  a[2] = middle_2 + across_2;
  a[3] = middle_2 - across_2;
  a[4] = middle_1 - across_1;
}

/// Takes transforms of `length` values, `stride` of which are interleaved, to transforms of a
/// Factor'th of that, Factor times as many.
template <std::size_t Factor>
[[gnu::always_inline]] inline void pass(const Root* roots, std::size_t length, std::size_t stride,
                                        const Place* in, Place* out) noexcept {
  const std::size_t part = length / Factor;
  for (std::size_t p = 0; p < part; ++p)
    for (std::size_t q = 0; q < stride; ++q) {
      Place a[Factor];
      for (std::size_t j = 0; j < Factor; ++j) a[j] = in[q + stride * (p + j * part)];
      transform(a);
      out[q + stride * Factor * p] = a[0];
      for (std::size_t i = 1; i < Factor; ++i) {
        const Root root = roots[p * i * stride];
        out[q + stride * (Factor * p + i)] = multiply(a[i], root.real(), root.imag());
      }
    }
}

std::size_t find_factor(std::size_t length) {
  for (const std::size_t factor : {std::size_t{5}, std::size_t{4}, std::size_t{3}})
    if (length % factor == 0) return factor;
  assert(length % 2 == 0);
  return 2;
}

}  // namespace

void EightSeries::set(std::size_t k, const std::array<std::complex<double>, kCount>& coefficients) {
  Double4 re[2], im[2];
  for (int i = 0; i < 4; ++i)
    for (const int half : {0, 1}) {
      re[half][i] = coefficients[4 * half + i].real();
      im[half][i] = coefficients[4 * half + i].imag();
    }
  places[k] = {re[0] - im[1], im[0] + re[1]};
  places[places.size() - k] = {re[0] + im[1], re[1] - im[0]};
}

InverseFourier::InverseFourier(std::size_t length) : other_(length) {
  for (std::size_t rest = length; rest > 1; rest /= factors_.back())
    factors_.push_back(find_factor(rest));
  for (std::size_t j = 0; j < length; ++j)
    roots_.push_back(std::polar(
        1.0, 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(length)));
}

void InverseFourier::transform(EightSeries& series) {
  assert(series.places.size() == other_.places.size());
  std::size_t length = series.places.size(), stride = 1;
  for (const std::size_t factor : factors_) {
    const Place* in = series.places.data();
    Place* out = other_.places.data();
    run_large_kernel([&]() noexcept {
      switch (factor) {
        case 5:
          return pass<5>(roots_.data(), length, stride, in, out);
        case 4:
          return pass<4>(roots_.data(), length, stride, in, out);
        case 3:
          return pass<3>(roots_.data(), length, stride, in, out);
        default:
          return pass<2>(roots_.data(), length, stride, in, out);
      }
    });
    std::swap(series.places, other_.places);
    length /= factor;
    stride *= factor;
  }
}

}  // namespace spoke::air
