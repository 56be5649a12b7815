#pragma once

// Memory that a thread reads or writes next, fetched while it still works on something else. A
// processor does so by itself along a stretch, but not from one stretch to another.

#include <algorithm>
#include <cstddef>

namespace spoke {

/// Fetches the lines of a stretch, of a long one the first: along it the processor goes on.
inline void prefetch(const void* first, std::size_t bytes) noexcept {
  constexpr std::size_t kLine = 64, kMost = 64 * kLine;
  const char* at = static_cast<const char*>(first);
  for (std::size_t k = 0; k < std::min(bytes, kMost); k += kLine) __builtin_prefetch(at + k, 0, 2);
}

}  // namespace spoke
