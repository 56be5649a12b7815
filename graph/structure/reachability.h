#pragma once

// Sets of nodes that each node reaches.

#include <cstdint>
#include <vector>

namespace spoke::graph {

/// A square table of bits: for each node, the set of nodes it reaches (or is reached from).
class Reachability {
 public:
  explicit Reachability(int nodes)
      : words_per_row_((static_cast<std::size_t>(nodes) + 63) / 64),
        words_(words_per_row_ * static_cast<std::size_t>(nodes)) {}

  bool contains(int row, int node) const { return (word(row, node) >> (node % 64)) & 1U; }

  /// Adds `node` and the whole set of `node` to the set of `row`.
  void absorb(int row, int node) {
    const std::size_t to = begin_of(row);
    const std::size_t from = begin_of(node);
    for (std::size_t w = 0; w < words_per_row_; ++w) words_[to + w] |= words_[from + w];
    words_[to + static_cast<std::size_t>(node / 64)] |= std::uint64_t{1} << (node % 64);
  }

 private:
  std::size_t begin_of(int row) const { return static_cast<std::size_t>(row) * words_per_row_; }
  std::uint64_t word(int row, int node) const {
    return words_[begin_of(row) + static_cast<std::size_t>(node / 64)];
  }

  std::size_t words_per_row_;
  std::vector<std::uint64_t> words_;
};

}  // namespace spoke::graph
