// Factorises block by block of columns, each when those that change it are done.

#include "engine/bodies/space/sparse_factor.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "models/support/simd.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Memory of one factorisation, and what is known of the blocks that are done.
struct FactorWork {
  explicit FactorWork(const SparseFactor& factor)
      : block_of(index(factor.size)),
        place(index(factor.size), 0),
        next_row(factor.blocks.size(), 0),
        waiting(factor.blocks.size()) {
    std::size_t most = 0;
    int widest = 0;
    for (std::size_t b = 0; b < factor.blocks.size(); ++b) {
      const ColumnBlock& block = factor.blocks[b];
      std::fill_n(block_of.begin() + block.first, block.width, static_cast<int>(b));
      most = std::max(most, index(4 * block.groups() + 4));
      widest = std::max(widest, block.width);
    }
    products.resize(most * index(widest + 4));
  }

  std::vector<int> block_of;  ///< by coordinate
  std::vector<int> place;     ///< by row of the block in work: its place among the block's rows
  std::vector<int> next_row;  ///< by block that is done: its first row that has not been used yet
  std::vector<std::vector<int>> waiting;  ///< by block: those that change it, as far as known
  std::vector<double> products;           ///< column by column
};

void put_matrix(const Sparse& matrix, const ColumnBlock& block, const FactorWork& work,
                SparseFactor& factor) {
  double* const diagonal = &factor.values[block.diagonal];
  double* const below = factor.values.data() + block.below;
  for (int k = 0; k < block.width; ++k)
    for (Sparse::InnerIterator e(matrix, block.first + k); e; ++e) {
      const auto i = static_cast<int>(e.row());
      if (i < block.first + k) continue;
      if (i < block.end()) {
        diagonal[block.width * k + i - block.first] = e.value();
      } else {
        const int r = work.place[index(i)];
        below[index(r / 4 * 4) * index(block.width) + index(4 * k + r % 4)] = e.value();
      }
    }
}

/// Calculates products of four columns' rows [group, groups) with rows c to c + 3: kGroups groups
/// at a time.
template <int kGroups>
[[gnu::always_inline]] inline void multiply_tile(const double* rows, const double* const (&c)[4],
                                                 int width, double* products, int stride) {
  Double4 sums[kGroups][4]{};
  const int next = 4 * width;
  for (int k = 0; k < width; ++k) {
    const double factors[4] = {c[0][4 * k], c[1][4 * k], c[2][4 * k], c[3][4 * k]};
    for (int g = 0; g < kGroups; ++g) {
      const Double4 row = load4(rows + g * next + 4 * k);
      for (int i = 0; i < 4; ++i) sums[g][i] += row * factors[i];
    }
  }
  for (int g = 0; g < kGroups; ++g)
    for (int i = 0; i < 4; ++i) store(sums[g][i], products + i * stride + 4 * g);
}

/// Calculates the products of all rows from `first` on, rounded down to a group, with those of the
/// rows [first, end): columns of `stride` values.
void multiply_rows(const double* below, int width, int groups, int first, int end, double* products,
                   int stride) {
  const int first_group = first / 4;
  for (int column = first; column < end; column += 4) {
    const double* c[4];
    for (int i = 0; i < 4; ++i) {
      const int r = std::min(column + i, end - 1);
      c[i] = below + static_cast<std::ptrdiff_t>(r / 4) * 4 * width + r % 4;
    }
    double* out = products + static_cast<std::ptrdiff_t>(column - first) * stride;
    int g = first_group;
    for (; g + 2 <= groups; g += 2)
      multiply_tile<2>(below + static_cast<std::ptrdiff_t>(g) * 4 * width, c, width,
                       out + 4 * (g - first_group), stride);
    if (g < groups)
      multiply_tile<1>(below + static_cast<std::ptrdiff_t>(g) * 4 * width, c, width,
                       out + 4 * (g - first_group), stride);
  }
}

/// Takes off what a block that is done makes of the rows of another; returns its first row behind
/// them.
int subtract_products(const ColumnBlock& done, int first, const ColumnBlock& block,
                      FactorWork& work, SparseFactor& factor) {
  const int* rows = &factor.rows[done.row];
  int end = first;
  while (end < done.rows && rows[end] < block.end()) ++end;
  const int first_group = first / 4, stride = 4 * (done.groups() - first_group);
  multiply_rows(&factor.values[done.below], done.width, done.groups(), first, end,
                work.products.data(), stride);
  double* const diagonal = &factor.values[block.diagonal];
  double* const below = factor.values.data() + block.below;
  for (int c = first; c < end; ++c) {
    const int k = rows[c] - block.first;
    const double* products = &work.products[index(c - first) * index(stride)] -
                             static_cast<std::ptrdiff_t>(4) * first_group;
    for (int r = c; r < end; ++r) diagonal[block.width * k + rows[r] - block.first] -= products[r];
    double* const column = below + 4 * k;
    for (int r = end; r < done.rows; ++r) {
      const int to = work.place[index(rows[r])];
      column[static_cast<std::ptrdiff_t>(to / 4) * 4 * block.width + to % 4] -= products[r];
    }
  }
  return end;
}

/// Factorises the block's own rows; its pivots are inverted.
void factorise_diagonal(int n, double* a) {
  for (int k = 0; k < n; ++k) {
    double* const column = a + n * k;
    assert(!(column[k] <= 0.0) && "positive definite");
    column[k] = 1.0 / std::sqrt(column[k]);
    for (int i = k + 1; i < n; ++i) column[i] *= column[k];
    for (int j = k + 1; j < n; ++j) {
      const double factor = column[j];
      for (int i = j; i < n; ++i) a[n * j + i] -= factor * column[i];
    }
  }
}

/// Multiplies kGroups groups of rows by L^-T of the block.
template <int kGroups>
[[gnu::always_inline]] inline void solve_groups(int width, const double* diagonal, double* rows) {
  const int next = 4 * width;
  for (int k = 0; k < width; ++k) {
    Double4 sums[kGroups];
    for (int g = 0; g < kGroups; ++g) sums[g] = load4(rows + g * next + 4 * k);
    for (int j = 0; j < k; ++j) {
      const double factor = diagonal[width * j + k];
      for (int g = 0; g < kGroups; ++g) sums[g] -= factor * load4(rows + g * next + 4 * j);
    }
    for (int g = 0; g < kGroups; ++g)
      store(diagonal[width * k + k] * sums[g], rows + g * next + 4 * k);
  }
}

void solve_below(const ColumnBlock& block, SparseFactor& factor) {
  const double* const diagonal = &factor.values[block.diagonal];
  double* rows = factor.values.data() + block.below;
  int g = 0;
  for (; g + 4 <= block.groups(); g += 4, rows += 16 * block.width)
    solve_groups<4>(block.width, diagonal, rows);
  for (; g < block.groups(); ++g, rows += 4 * block.width)
    solve_groups<1>(block.width, diagonal, rows);
}

void factorise_values(const Sparse& matrix, FactorWork& work, SparseFactor& factor) {
  for (std::size_t b = 0; b < factor.blocks.size(); ++b) {
    const ColumnBlock& block = factor.blocks[b];
    const int* rows = factor.rows.data() + block.row;
    for (int r = 0; r < block.rows; ++r) work.place[index(rows[r])] = r;
    put_matrix(matrix, block, work, factor);
    const auto wait_on = [&](std::size_t done, int next) {
      const ColumnBlock& inner = factor.blocks[done];
      work.next_row[done] = next;
      if (next == inner.rows) return;
      const int row = factor.rows[inner.row + index(next)];
      work.waiting[index(work.block_of[index(row)])].push_back(static_cast<int>(done));
    };
    for (const int done : work.waiting[b])
      wait_on(index(done), subtract_products(factor.blocks[index(done)], work.next_row[index(done)],
                                             block, work, factor));
    factorise_diagonal(block.width, &factor.values[block.diagonal]);
    solve_below(block, factor);
    wait_on(b, 0);
  }
}

}  // namespace

SparseFactor factorise(const Sparse& matrix, const std::vector<int>& slices) {
  SparseFactor factor = make_structure(matrix, slices);
  FactorWork work(factor);
  run_large_kernel([&]() noexcept { factorise_values(matrix, work, factor); });
  return factor;
}

}  // namespace spoke::space
