#pragma once

// Random numbers whose bits depend on nothing but the seed: integers by xoshiro256++ (Blackman &
// Vigna 2021), seeded by splitmix64 (Steele et al. 2014), and points of the unit circle.

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>

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
  /// Returns a point of the unit circle, e^(i phi) with a uniform phase phi: a point of the disc by
  /// trial, its angle doubled (Marsaglia 1972), so that only basic arithmetic is used.
  std::complex<double> phasor() {
    for (;;) {
      const double x = symmetric();
      const double y = symmetric();
      const double square = x * x + y * y;
      if (square > 1.0 || square < 0x1p-40) continue;
      return {(x * x - y * y) / square, 2.0 * x * y / square};
    }
  }

 private:
  static std::uint64_t turn(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

  std::array<std::uint64_t, 4> state_{};
};

}  // namespace spoke::air
