// Finds which columns of a Cholesky factor have the same rows, and joins those that nearly have.

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "engine/bodies/space/sparse_factor.h"

namespace spoke::space {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Calls `visit(i)` for the rows i < j of column j.
template <class Visit>
void for_above(const Sparse& matrix, int j, Visit&& visit) {
  for (Sparse::InnerIterator e(matrix, j); e && e.row() < j; ++e) visit(static_cast<int>(e.row()));
}

/// The elimination tree, and how many rows each column has below its diagonal.
struct ColumnTree {
  std::vector<int> parent;
  std::vector<int> below;

  explicit ColumnTree(const Sparse& matrix) {
    const auto n = static_cast<int>(matrix.cols());
    parent.assign(at(n), n);
    below.assign(at(n), 0);
    std::vector<int> ancestor(at(n), n);
    for (int j = 0; j < n; ++j)
      for_above(matrix, j, [&](int i) {
        while (ancestor[at(i)] != j) {
          const int next = std::exchange(ancestor[at(i)], j);
          if (next == n) {
            if (i != j) parent[at(i)] = j;
            break;
          }
          i = next;
        }
      });
    std::vector<int> mark(at(n));
    for (int j = 0; j < n; ++j) {
      mark[at(j)] = j;
      for_above(matrix, j, [&](int i) {
        for (; mark[at(i)] != j; i = parent[at(i)]) {
          mark[at(i)] = j;
          ++below[at(i)];
        }
      });
    }
  }
};

/// A stretch of columns that are to be one block.
struct Stretch {
  int first, end;
  long long entries;  ///< entries of L in them that are not zero

  int width() const { return end - first; }
};

/// Whether a block may hold so many zeros among so many entries.
bool may_join(int width, double zeros, double entries) {
  const double share = width <= 6 ? 0.4 : width <= 16 ? 0.15 : 0.06;
  return width <= kWidestBlock && zeros <= share * entries;
}

/// Joins the last stretches while the block that results has few zeros. All entries count that L
/// has in the columns, those of the diagonal too.
void join_last(const ColumnTree& tree, int part_begin, std::vector<Stretch>& stretches) {
  while (stretches.size() > 1) {
    const Stretch& last = stretches.back();
    const Stretch& before = stretches[stretches.size() - 2];
    if (before.first < part_begin) return;
    const int parent = tree.parent[at(before.end - 1)];
    if (parent < last.first || parent >= last.end) return;
    const int width = last.end - before.first;
    const long long rows = tree.below[at(last.end - 1)];
    const long long all = rows * width + static_cast<long long>(width) * (width + 1) / 2;
    const long long entries = before.entries + last.entries;
    if (!may_join(width, static_cast<double>(all - entries), static_cast<double>(all))) return;
    const Stretch joined{before.first, last.end, entries};
    stretches.pop_back();
    stretches.back() = joined;
  }
}

std::vector<Stretch> find_stretches(const ColumnTree& tree, const std::vector<int>& parts, int n) {
  std::vector<Stretch> stretches;
  std::size_t part = 0;
  int part_begin = 0;
  for (int j = 0; j < n; ++j) {
    const int open_part = part_begin;
    while (part < parts.size() && parts[part] <= j) part_begin = parts[part++];
    const bool begins = j == part_begin;
    const long long entries = 1 + tree.below[at(j)];
    if (!begins && tree.parent[at(j - 1)] == j && tree.below[at(j - 1)] == tree.below[at(j)] + 1 &&
        stretches.back().width() < kWidestBlock) {
      stretches.back().end = j + 1;
      stretches.back().entries += entries;
      continue;
    }
    join_last(tree, open_part, stretches);
    stretches.push_back({j, j + 1, entries});
  }
  join_last(tree, part_begin, stretches);
  return stretches;
}

/// Sets the rows of all blocks: those of the matrix, and those of blocks whose first row is theirs.
void find_rows(const Sparse& matrix, SparseFactor& factor) {
  const std::size_t count = factor.blocks.size();
  std::vector<int> block_of(at(factor.size)), mark(at(factor.size), -1);
  for (std::size_t b = 0; b < count; ++b)
    for (int j = factor.blocks[b].first; j < factor.blocks[b].end(); ++j)
      block_of[at(j)] = static_cast<int>(b);
  std::vector<std::vector<int>> children(count);
  std::vector<int> rows;
  for (std::size_t b = 0; b < count; ++b) {
    ColumnBlock& block = factor.blocks[b];
    rows.clear();
    const auto add = [&](int i) {
      if (i < block.end() || mark[at(i)] == static_cast<int>(b)) return;
      mark[at(i)] = static_cast<int>(b);
      rows.push_back(i);
    };
    for (int j = block.first; j < block.end(); ++j)
      for (Sparse::InnerIterator e(matrix, j); e; ++e) add(static_cast<int>(e.row()));
    for (const int child : children[b]) {
      const ColumnBlock& inner = factor.blocks[at(child)];
      for (int r = 0; r < inner.rows; ++r) add(factor.rows[inner.row + at(r)]);
    }
    std::sort(rows.begin(), rows.end());
    block.rows = static_cast<int>(rows.size());
    block.row = factor.rows.size();
    if (!rows.empty()) children[at(block_of[at(rows.front())])].push_back(static_cast<int>(b));
    factor.rows.insert(factor.rows.end(), rows.begin(), rows.end());
  }
}

/// Places the blocks' values one after another, in the order of the columns.
void place_values(SparseFactor& factor) {
  std::size_t used = 0;
  for (ColumnBlock& block : factor.blocks) {
    block.diagonal = used;
    used += at(block.width * block.width);
    used += (4 - used % 4) % 4;
    block.below = used;
    used += at(4 * block.groups()) * at(block.width);
  }
  factor.values.assign(used, 0.0);
}

/// Finds the blocks of each slice, and the coordinates between slices that they reach.
void set_slices(const std::vector<int>& slices, SparseFactor& factor) {
  const int between = slices.empty() ? factor.size : slices.back();
  const auto begin_of = [&factor](int coordinate) {
    const auto at_block =
        std::lower_bound(factor.blocks.begin(), factor.blocks.end(), coordinate,
                         [](const ColumnBlock& block, int i) { return block.first < i; });
    return static_cast<int>(at_block - factor.blocks.begin());
  };
  const auto make = [&](int first, int end) {
    FactorSlice slice;
    slice.first = first;
    slice.end = end;
    slice.first_block = begin_of(first);
    slice.end_block = begin_of(end);
    return slice;
  };
  const std::size_t count = slices.empty() ? 1 : slices.size() - 1;
  for (std::size_t p = 0; p < count; ++p) {
    FactorSlice slice =
        make(slices.empty() ? 0 : slices[p], p + 1 < count ? slices[p + 1] : between);
    int low = factor.size, high = between;
    for (int b = slice.first_block; b < slice.end_block; ++b) {
      const ColumnBlock& block = factor.blocks[at(b)];
      for (int r = 0; r < block.rows; ++r) {
        const int row = factor.rows[block.row + at(r)];
        assert((row < slice.end || row >= between) && "slices are independent");
        if (row < between) continue;
        low = std::min(low, row);
        high = std::max(high, row + 1);
      }
    }
    if (low < high) {
      slice.first_between = low;
      slice.end_between = high;
    }
    slice.share = factor.shares;
    factor.shares += slice.end_between - slice.first_between;
    factor.slices.push_back(slice);
  }
  factor.between = make(between, factor.size);
}

}  // namespace

SparseFactor make_structure(const Sparse& matrix, const std::vector<int>& slices) {
  assert(matrix.rows() == matrix.cols() && matrix.isCompressed());
  SparseFactor factor;
  factor.size = static_cast<int>(matrix.cols());
  const ColumnTree tree(matrix);
  for (const Stretch& stretch : find_stretches(tree, slices, factor.size)) {
    ColumnBlock block;
    block.first = stretch.first;
    block.width = stretch.width();
    factor.blocks.push_back(block);
  }
  find_rows(matrix, factor);
  place_values(factor);
  set_slices(slices, factor);
  return factor;
}

}  // namespace spoke::space
