#pragma once

// Even, contiguous shares of a loop.

#include <cassert>
#include <cstddef>

namespace spoke::graph {

/// The items [begin, end) of a loop that one thread runs.
struct StaticShare {
  std::size_t begin;
  std::size_t end;
};

/// Returns contiguous shares in the order of threads, whose sizes differ by one at most: neighbours
/// in memory stay with one thread, which is the same in every loop of equally many items. The first
/// threads get the larger shares, for they hand out the work and so begin earlier.
inline StaticShare static_share(std::size_t items, int thread, int threads) {
  assert(thread >= 0 && thread < threads);
  const auto t = static_cast<std::size_t>(thread);
  const auto n = static_cast<std::size_t>(threads);
  return {(t * items + n - 1) / n, ((t + 1) * items + n - 1) / n};
}

}  // namespace spoke::graph
