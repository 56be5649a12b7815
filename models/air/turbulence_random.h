#pragma once

// Random numbers whose bits depend on nothing but the seed: integers by xoshiro256++ (Blackman &
// Vigna 2021), seeded by splitmix64 (Steele et al. 2014), and points of the unit circle.

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

namespace spoke::air {

/// A stream of random numbers.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {  // splitmix64
      seed += 0x9e3779b97f4a7c15u;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
      word = z ^ (z >> 31);
    }
  }

  /// Returns 64 random bits.
  std::uint64_t bits() {
    const std::uint64_t result = turn(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = turn(state_[3], 45);
    return result;
  }
  /// Returns a number from -1, included, to 1, all steps of 2^-52 being equally probable.
  double symmetric() { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1.0; }
  /// Sets points of the unit circle, e^(i phi) with uniform phases phi: points of the disc by
  /// trial, their angles doubled (Marsaglia 1972), so that only basic arithmetic is used.
  void draw_phasors(std::span<std::complex<double>> out) {
    for (std::size_t found = 0; found < out.size();) {  // without a jump that nobody foresees
      const double x = symmetric();
      const double y = symmetric();
      out[found] = {x, y};
      const double square = x * x + y * y;
      found += static_cast<std::size_t>((square <= 1.0) & (square >= 0x1p-40));
    }
    for (std::complex<double>& point : out) {
      const double x = point.real(), y = point.imag();
      const double square = x * x + y * y;
      point = {(x * x - y * y) / square, 2.0 * x * y / square};
    }
  }

 private:
  static std::uint64_t turn(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

  std::array<std::uint64_t, 4> state_{};
};

}  // namespace spoke::air
