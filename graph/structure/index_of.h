#pragma once

// Handles as places in arrays.

#include <cassert>
#include <cstddef>

namespace spoke::graph {

/// Returns a 0-based index as std::size_t. Precondition: index >= 0.
constexpr std::size_t index_of(int index) {
  assert(index >= 0);
  return static_cast<std::size_t>(index);
}

/// Returns the index of a handle such as NodeId or PartId as std::size_t. Precondition: it is not
/// negative.
template <class Handle>
requires requires(Handle handle) { handle.index; }
constexpr std::size_t index_of(Handle handle) { return index_of(handle.index); }

}  // namespace spoke::graph
