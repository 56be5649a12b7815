// SplitMix64 as a hash, and a Feistel network on it.

#include "program/study/random_bits.h"

#include <cassert>

namespace spoke::study {
namespace {

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;  // the increment of SplitMix64
constexpr int kRounds = 6;

}  // namespace

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  const std::uint64_t of_seed = mix((seed + 1) * kGolden);
  const std::uint64_t of_stream = mix(of_seed + (stream + 1) * kGolden);
  return mix(of_stream + (index + 1) * kGolden);
}

double random_number(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  const std::uint64_t bits = random_bits(seed, stream, index) >> 11;
  return (static_cast<double>(bits) + 0.5) * 0x1p-53;
}

std::uint64_t permuted(std::uint64_t seed, std::uint64_t stream, std::uint64_t index,
                       std::uint64_t count) {
  assert(index < count && count <= (std::uint64_t{1} << 62));
  int half = 1;
  while ((std::uint64_t{1} << (2 * half)) < count) ++half;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = index >> half, right = index & mask;
    for (std::uint64_t round = 0; round < kRounds; ++round) {
      const std::uint64_t next = left ^ (random_bits(seed, stream * kRounds + round, right) & mask);
      left = right;
      right = next;
    }
    index = (left << half) | right;
  } while (index >= count);
  return index;
}

}  // namespace spoke::study
