#pragma once

// Symmetric matrices whose entries lie near the diagonal, if rows are in a good order: of each row
// of the lower triangle what lies between its first entry and the diagonal is stored (a skyline, or
// envelope). Cholesky's factor has the same entries.

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/support/page_arena.h"

namespace spoke {

class Skyline {
 public:
  Skyline() = default;
  /// Zeros; `first`: column of the first entry of each row, not behind the diagonal.
  Skyline(std::vector<int> first, Arena& arena);

  int rows() const { return static_cast<int>(first_.size()); }
  int first(int r) const { return first_[static_cast<std::size_t>(r)]; }
  double& entry(int r, int c) {
    assert(first(r) <= c && c <= r && r < rows());
    return values_[begin_[static_cast<std::size_t>(r)] + static_cast<std::size_t>(c)];
  }
  std::span<double> values() { return values_; }
  void set_zero() noexcept;

  /// Returns an element of the lower triangle; 0 where none is stored.
  double value(int r, int c) const {
    assert(0 <= c && c <= r && r < rows());
    return c < first(r)
               ? 0.0
               : values_[begin_[static_cast<std::size_t>(r)] + static_cast<std::size_t>(c)];
  }

  // The first `count` rows are eliminated; what they leave of the others is their Schur complement.
  // With all rows that is the whole matrix.

  /// Puts the factor [L 0; B 1] of a matrix [L L^T, L B^T; B L^T, B B^T + S] in its place, with S,
  /// the Schur complement, in that of its last block; `pivots`: squares of L's diagonal as they
  /// come out. One that has vanished is replaced, so that the rest stays finite.
  void factorise(std::span<double> pivots, int count) noexcept;

  /// Puts [L 0; B 1]^-1 x in the place of x, of numbers or vectors.
  template <class Columns>
  void solve_lower(Columns& x, int count) {
    for (int r = 0; r < rows(); ++r) {
      auto& own = x[static_cast<std::size_t>(r)];
      for (int c = first(r); c < r && c < count; ++c)
        own -= entry(r, c) * x[static_cast<std::size_t>(c)];
      if (r < count) own /= entry(r, r);
    }
  }
  /// Puts [L 0; B 1]^-T x in the place of x.
  void solve_upper(std::span<double> x, int count) noexcept;

 private:
  std::vector<int> first_;
  std::vector<std::size_t> begin_;  ///< of each row the place where its column 0 were
  ArenaVector<double> values_;
};

/// Returns an order of the nodes of a graph by which its skyline is low: as they are numbered, or
/// from one end of each part to the other (the reverse of Cuthill and McKee's) if that takes fewer
/// products. `neighbours`: of each node, itself not among them; `sizes`: rows of each node.
std::vector<int> find_low_order(const std::vector<std::vector<int>>& neighbours,
                                const std::vector<int>& sizes);

}  // namespace spoke
