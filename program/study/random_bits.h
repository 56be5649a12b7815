#pragma once

// Random numbers that are functions of seed, stream and index, not of earlier draws: any run's
// values can be computed alone, in any order, on any machine, to the same bits.

#include <cstdint>

namespace spoke::study {

/// Returns 64 random bits: the output function of SplitMix64 (G. L. Steele, D. Lea, C. H. Flood,
/// "Fast splittable pseudorandom number generators", OOPSLA 2014), applied to the seed, then with
/// the stream, then with the index added, each times an odd constant.
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Returns the upper 53 of these bits, as the middle of one of 2^53 equal parts of (0, 1).
double random_number(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Returns where a permutation of 0 ... count - 1 takes `index`. It is a Feistel network of six
/// rounds on the least even number of bits that holds `count`, repeated until the result is below
/// `count`.
std::uint64_t permuted(std::uint64_t seed, std::uint64_t stream, std::uint64_t index,
                       std::uint64_t count);

}  // namespace spoke::study
