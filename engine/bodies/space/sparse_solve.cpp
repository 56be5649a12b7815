// Takes four rows of a block's columns at a time.

#include "engine/bodies/space/sparse_solve.h"

#include <algorithm>
#include <cassert>

#include "models/support/simd.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

constexpr int kHalfRow = 4;  ///< columns of half solutions

/// Where the rows of half solutions stand: those of a slice, and from `split` on its share.
struct HalfRows {
  double* y;
  double* share;  ///< as if it held all rows
  int split;

  [[gnu::always_inline]] double* at(int row) const {
    return (row < split ? y : share) + static_cast<std::ptrdiff_t>(kHalfRow) * row;
  }
};

void solve_diagonal(int width, const double* diagonal, double* y) {
  for (int k = 0; k < width; ++k, diagonal += width) {
    const Double4 solution = diagonal[k] * load4(y + kHalfRow * k);
    store(solution, y + kHalfRow * k);
    for (int i = k + 1; i < width; ++i)
      store(load4(y + kHalfRow * i) - diagonal[i] * solution, y + kHalfRow * i);
  }
}

/// Takes the products of kGroups groups of rows with the solutions y off the rows.
template <int kGroups>
[[gnu::always_inline]] inline void subtract_groups(const double* below, int width, const double* y,
                                                   const int* rows, int count,
                                                   const HalfRows& half) {
  Double4 sums[kGroups][4]{};
  const int next = 4 * width;
  for (int k = 0; k < width; ++k) {
    const Double4 solution = load4(y + kHalfRow * k);
    for (int g = 0; g < kGroups; ++g)
      for (int i = 0; i < 4; ++i) sums[g][i] += below[g * next + 4 * k + i] * solution;
  }
  for (int g = 0; g < kGroups; ++g)
    for (int i = 0; i < 4 && 4 * g + i < count; ++i) {
      double* const row = half.at(rows[4 * g + i]);
      store(load4(row) - sums[g][i], row);
    }
}

void solve_half_blocks(const SparseFactor& factor, const FactorSlice& slice, const HalfRows& half) {
  for (int b = slice.first_block; b < slice.end_block; ++b) {
    const ColumnBlock& block = factor.blocks[static_cast<std::size_t>(b)];
    double* const y = half.y + static_cast<std::ptrdiff_t>(kHalfRow) * block.first;
    solve_diagonal(block.width, &factor.values[block.diagonal], y);
    const double* below = factor.values.data() + block.below;
    const int* rows = factor.rows.data() + block.row;
    int left = block.rows;
    for (; left > 4; left -= 8, rows += 8, below += 8 * block.width)
      subtract_groups<2>(below, block.width, y, rows, left, half);
    if (left > 0) subtract_groups<1>(below, block.width, y, rows, left, half);
  }
}

/// Adds the products of rows below, with their solutions x, to the sums of each column.
void add_columns(const double* below, int width, const double* x, int groups, Double4* sums) {
  constexpr int kColumns = 6;
  const auto add = [&](auto columns, int first) __attribute__((always_inline)) {
    constexpr int n = columns;
    Double4 part[n];
    for (int k = 0; k < n; ++k) part[k] = sums[first + k];
    const double* column = below + static_cast<std::ptrdiff_t>(4) * first;
    for (int g = 0; g < groups; ++g, column += static_cast<std::ptrdiff_t>(4) * width) {
      const Double4 four = load4(x + 4 * g);
      for (int k = 0; k < n; ++k) part[k] += load4(column + 4 * k) * four;
    }
    for (int k = 0; k < n; ++k) sums[first + k] = part[k];
  };
  int k = 0;
  for (; k + kColumns <= width; k += kColumns) add(std::integral_constant<int, kColumns>{}, k);
  for (; k + 3 <= width; k += 3) add(std::integral_constant<int, 3>{}, k);
  for (; k < width; ++k) add(std::integral_constant<int, 1>{}, k);
}

void solve_back_block(const SparseFactor& factor, const ColumnBlock& block, double* x) {
  assert(block.width <= kWidestBlock);
  constexpr int kChunk = 64;  // groups
  Double4 sums[kWidestBlock]{};
  const double* below = factor.values.data() + block.below;
  const int* rows = factor.rows.data() + block.row;
  double gathered[4 * kChunk];
  for (int done = 0; done < block.rows; done += 4 * kChunk) {
    const int count = std::min(4 * kChunk, block.rows - done), groups = (count + 3) / 4;
    for (int r = 0; r < count; ++r) gathered[r] = x[rows[done + r]];
    for (int r = count; r < 4 * groups; ++r) gathered[r] = 0.0;
    add_columns(below, block.width, gathered, groups, sums);
    below += static_cast<std::ptrdiff_t>(4) * groups * block.width;
  }
  double* const own = x + block.first;
  const double* const diagonal = &factor.values[block.diagonal];
  for (int k = block.width - 1; k >= 0; --k) {
    const Double4& s = sums[k];
    double rest = own[k] - ((s[0] + s[1]) + (s[2] + s[3]));
    for (int i = k + 1; i < block.width; ++i) rest -= diagonal[block.width * k + i] * own[i];
    own[k] = diagonal[block.width * k + k] * rest;
  }
}

void solve_back_blocks(const SparseFactor& factor, const FactorSlice& slice, double* x) {
  for (int b = slice.end_block; b-- > slice.first_block;)
    solve_back_block(factor, factor.blocks[static_cast<std::size_t>(b)], x);
}

void copy_rows(const double* b, double* y, int first, int end) {
  if (b == y) return;
  std::copy(b + static_cast<std::ptrdiff_t>(kHalfRow) * first,
            b + static_cast<std::ptrdiff_t>(kHalfRow) * end,
            y + static_cast<std::ptrdiff_t>(kHalfRow) * first);
}

const FactorSlice& slice_of(const SparseFactor& factor, int p) {
  return factor.slices[static_cast<std::size_t>(p)];
}
double* share_of(const SparseFactor& factor, const FactorSlice& slice, double* y) {
  return y + static_cast<std::ptrdiff_t>(kHalfRow) * (factor.size + slice.share);
}

}  // namespace

void solve_half_slice(const SparseFactor& factor, int p, const double* b, double* y) noexcept {
  const FactorSlice& slice = slice_of(factor, p);
  copy_rows(b, y, slice.first, slice.end);
  double* const share = share_of(factor, slice, y);
  std::fill_n(share, kHalfRow * (slice.end_between - slice.first_between), 0.0);
  const HalfRows half{y, share - static_cast<std::ptrdiff_t>(kHalfRow) * slice.first_between,
                      factor.between.first};
  run_large_kernel([&]() noexcept { solve_half_blocks(factor, slice, half); });
}

void solve_half_between(const SparseFactor& factor, const double* b, double* y) noexcept {
  copy_rows(b, y, factor.between.first, factor.between.end);
  for (const FactorSlice& slice : factor.slices) {
    const double* share = share_of(factor, slice, y);
    double* row = y + static_cast<std::ptrdiff_t>(kHalfRow) * slice.first_between;
    for (int i = slice.first_between; i < slice.end_between;
         ++i, row += kHalfRow, share += kHalfRow)
      store(load4(row) + load4(share), row);
  }
  run_large_kernel([&]() noexcept {
    solve_half_blocks(factor, factor.between, {y, nullptr, factor.size});
  });
}

void solve_back_between(const SparseFactor& factor, double* x) noexcept {
  run_large_kernel([&]() noexcept { solve_back_blocks(factor, factor.between, x); });
}

void solve_back_slice(const SparseFactor& factor, int p, double* x) noexcept {
  run_large_kernel([&]() noexcept { solve_back_blocks(factor, slice_of(factor, p), x); });
}

void solve_half(const SparseFactor& factor, const double* b, double* y) noexcept {
  for (int p = 0; p < static_cast<int>(factor.slices.size()); ++p)
    solve_half_slice(factor, p, b, y);
  solve_half_between(factor, b, y);
}

void solve_back(const SparseFactor& factor, double* x) noexcept {
  solve_back_between(factor, x);
  for (int p = 0; p < static_cast<int>(factor.slices.size()); ++p) solve_back_slice(factor, p, x);
}

}  // namespace spoke::space
