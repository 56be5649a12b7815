#pragma once

// Solutions by a sparse Cholesky factor, slice by slice. Half solutions L y = b have rows of four;
// y has SparseFactor::half_rows() of them. Any order of the slices yields the same bits.

#include "engine/bodies/space/sparse_factor.h"

namespace spoke::space {

/// Solves L y = b for the rows of slice p, in place or not, and sets its share in those between
/// slices.
void solve_half_slice(const SparseFactor& factor, int p, const double* b, double* y) noexcept;
/// Solves for the rows between slices, when all slices are done.
void solve_half_between(const SparseFactor& factor, const double* b, double* y) noexcept;

/// Solve L^T x = b in place: first for the coordinates between slices, then for those of slices.
void solve_back_between(const SparseFactor& factor, double* x) noexcept;
void solve_back_slice(const SparseFactor& factor, int p, double* x) noexcept;

/// Solve for all.
void solve_half(const SparseFactor& factor, const double* b, double* y) noexcept;
void solve_back(const SparseFactor& factor, double* x) noexcept;

}  // namespace spoke::space
