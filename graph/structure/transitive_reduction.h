#pragma once

// Dropping of edges that other paths of a graph imply.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/structure/index_of.h"

namespace spoke::graph {

// The nodes of a block of successive ones that lead to each node.
class AncestorsInBlock {
 public:
  explicit AncestorsInBlock(std::size_t nodes) : words_(nodes * kWords), has_any_(nodes) {}

  static constexpr std::size_t kNodes = 1024;

  // Forgets all, for a block that begins at node `first`.
  void begin(std::size_t first) {
    for (std::size_t node = first_; node < has_any_.size(); ++node)
      if (has_any_[node]) std::fill_n(row(node), kWords, 0);
    std::fill(has_any_.begin(), has_any_.end(), false);
    first_ = first;
  }
  bool is_in_block(std::size_t node) const { return node >= first_ && node < first_ + kNodes; }
  // Whether `ancestor` leads to `node`. Precondition: is_in_block(ancestor).
  bool leads_to(std::size_t node, std::size_t ancestor) {
    assert(is_in_block(ancestor));
    return (row(node)[(ancestor - first_) / 64] >> ((ancestor - first_) % 64)) & 1U;
  }
  // Adds `from` and its ancestors to those of `node`.
  void absorb(std::size_t node, std::size_t from) {
    if (is_in_block(from)) {
      row(node)[(from - first_) / 64] |= std::uint64_t{1} << ((from - first_) % 64);
      has_any_[node] = true;
    }
    if (!has_any_[from]) return;
    for (std::size_t w = 0; w < kWords; ++w) row(node)[w] |= row(from)[w];
    has_any_[node] = true;
  }

 private:
  static constexpr std::size_t kWords = kNodes / 64;

  std::uint64_t* row(std::size_t node) { return words_.data() + node * kWords; }

  std::size_t first_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<bool> has_any_;  // most rows are empty where subsystems are independent
};

// Drops edges from nodes of the block that begins at `first`. The order of the nodes is
// topological, so a predecessor is implied exactly if it is an ancestor of a later one: one pass
// from the latest down suffices.
template <class Id>
void reduce_from_block(std::size_t first, AncestorsInBlock& ancestors,
                       std::vector<std::vector<Id>>& predecessors) {
  ancestors.begin(first);
  for (std::size_t node = first + 1; node < predecessors.size(); ++node) {
    std::vector<Id>& before = predecessors[node];
    for (std::size_t k = before.size(); k-- > 0 && index_of(before[k]) >= first;) {
      const std::size_t from = index_of(before[k]);
      if (ancestors.is_in_block(from) && ancestors.leads_to(node, from))
        before.erase(before.begin() + static_cast<std::ptrdiff_t>(k));
      else
        ancestors.absorb(node, from);
    }
  }
}

/// Drops the edges that other paths imply. `predecessors`: per node, in a topological order,
/// ascending handles or 0-based indices, which may repeat. Works by blocks of ancestors, since a
/// table of all of them would grow with the square of the nodes.
template <class Id>
void reduce_transitively(std::vector<std::vector<Id>>& predecessors) {
  AncestorsInBlock ancestors(predecessors.size());
  for (std::size_t first = 0; first < predecessors.size(); first += AncestorsInBlock::kNodes)
    reduce_from_block(first, ancestors, predecessors);
}

}  // namespace spoke::graph
