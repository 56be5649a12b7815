#pragma once

// Even, contiguous shares of a loop.

#include <cstddef>

namespace spoke::graph {

/// The items [begin, end) of a loop that are one thread's.
struct StaticShare {
  std::size_t begin;
  std::size_t end;
};

/// Contiguous shares in the order of threads, whose sizes differ by one at most: neighbours in
/// memory stay with one thread, and the same one in every loop of as many items. The first threads
/// get the larger shares, for they hand out the work and so begin earlier.
inline StaticShare static_share(std::size_t items, int thread, int threads) {
  const auto t = static_cast<std::size_t>(thread);
  const auto n = static_cast<std::size_t>(threads);
  return {(t * items + n - 1) / n, ((t + 1) * items + n - 1) / n};
}

}  // namespace spoke::graph
