// Computes the recurrence of direction numbers, and their sums without carry.

#include "program/study/sobol_sequence.h"

#include <cassert>

namespace spoke::study {
namespace {

/// A dimension: degree and inner coefficients of its primitive polynomial, first direction numbers.
struct Polynomial {
  unsigned degree, coefficients;
  std::array<std::uint32_t, 9> m;
};

// The dimensions 2 to 50.
constexpr std::array<Polynomial, kMostSobolDimensions - 1> kPolynomials = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
    {7, 50, {1, 3, 1, 3, 5, 53, 69}},
    {7, 55, {1, 1, 5, 5, 23, 33, 13}},
    {7, 56, {1, 1, 7, 7, 1, 61, 123}},
    {7, 59, {1, 1, 7, 9, 13, 61, 49}},
    {7, 62, {1, 3, 3, 5, 3, 55, 33}},
    {8, 14, {1, 3, 1, 15, 31, 13, 49, 245}},
    {8, 21, {1, 3, 5, 15, 31, 59, 63, 97}},
    {8, 22, {1, 3, 1, 11, 11, 11, 77, 249}},
    {8, 38, {1, 3, 1, 11, 27, 43, 71, 9}},
    {8, 47, {1, 1, 7, 15, 21, 11, 81, 45}},
    {8, 49, {1, 3, 7, 3, 25, 31, 65, 79}},
    {8, 50, {1, 3, 1, 1, 19, 11, 3, 205}},
    {8, 52, {1, 1, 5, 9, 19, 21, 29, 157}},
    {8, 56, {1, 3, 7, 11, 1, 33, 89, 185}},
    {8, 67, {1, 3, 3, 3, 15, 9, 79, 71}},
    {8, 70, {1, 3, 7, 11, 15, 39, 119, 27}},
    {8, 84, {1, 1, 3, 1, 11, 31, 97, 225}},
    {8, 97, {1, 1, 1, 3, 23, 43, 57, 177}},
}};

std::array<std::uint32_t, 32> make_directions(const Polynomial& p) {
  std::array<std::uint32_t, 32> v{};
  const unsigned s = p.degree;
  for (unsigned k = 0; k < s; ++k) v[k] = p.m[k] << (31 - k);
  for (unsigned k = s; k < 32; ++k) {
    v[k] = v[k - s] ^ (v[k - s] >> s);
    for (unsigned j = 1; j < s; ++j)
      if (((p.coefficients >> (s - 1 - j)) & 1U) != 0) v[k] ^= v[k - j];
  }
  return v;
}

/// Makes the direction numbers of van der Corput's sequence.
std::array<std::uint32_t, 32> make_first_directions() {
  std::array<std::uint32_t, 32> v{};
  for (unsigned k = 0; k < 32; ++k) v[k] = std::uint32_t{1} << (31 - k);
  return v;
}

}  // namespace

SobolSequence::SobolSequence(int dimensions) {
  assert(1 <= dimensions && dimensions <= kMostSobolDimensions);
  directions_.push_back(make_first_directions());
  for (int d = 1; d < dimensions; ++d)
    directions_.push_back(make_directions(kPolynomials[static_cast<std::size_t>(d - 1)]));
}

std::uint32_t SobolSequence::coordinate(std::uint64_t index, int dimension) const {
  assert(index < (std::uint64_t{1} << 32));
  const Directions& v = directions_[static_cast<std::size_t>(dimension)];
  std::uint32_t x = 0;
  std::uint64_t gray = index ^ (index >> 1);
  for (std::size_t k = 0; gray != 0; ++k, gray >>= 1)
    if ((gray & 1U) != 0) x ^= v[k];
  return x;
}

}  // namespace spoke::study
