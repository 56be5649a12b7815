#pragma once

// The Cholesky factor of a sparse matrix whose rows and columns are ordered by slices, which it
// leaves independent: dense blocks of columns with the same rows.

#include <Eigen/SparseCore>
#include <vector>

namespace spoke::space {

/// Columns of one block at most: their solutions stay in the nearest cache.
inline constexpr int kWidestBlock = 48;

/// Neighbouring columns of L that have the same rows below them.
struct ColumnBlock {
  int first = 0;
  int width = 0;
  int rows = 0;              ///< rows below the block's own
  std::size_t row = 0;       ///< place of the first of these in SparseFactor::rows
  std::size_t diagonal = 0;  ///< place of its own rows: by column, width x width, pivots inverted
  /// Place of the rows below in the values: four rows side by side, column after column; those that
  /// are not there are zero.
  std::size_t below = 0;

  int groups() const { return (rows + 3) / 4; }
  int end() const { return first + width; }
};

/// What of the factor belongs to one slice: its columns. Its rows below them are of the slice and,
/// at the end of all, of coordinates between slices.
struct FactorSlice {
  int first = 0, end = 0;              ///< its coordinates
  int first_block = 0, end_block = 0;  ///< its blocks
  // Coordinates between slices that it may couple, and where its share in them stands: counted
  // behind all coordinates.
  int first_between = 0, end_between = 0;
  int share = 0;
};

/// L of a matrix L L^T.
struct SparseFactor {
  int size = 0;
  std::vector<FactorSlice> slices;
  FactorSlice between;  ///< coordinates that couple slices, and their columns
  int shares = 0;       ///< rows of all slices' shares
  std::vector<ColumnBlock> blocks;
  std::vector<int> rows;
  std::vector<double> values;

  /// Returns the rows that half solutions take: the coordinates, and the shares.
  int half_rows() const { return size + shares; }
};

/// Factorises a symmetric matrix, of which both triangles are stored; `slices`: as of NodalSolid,
/// may be empty. Precondition: it is positive definite.
SparseFactor factorise(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& slices);

/// The structure of the factor: all but its values, for which there is memory.
SparseFactor make_structure(const Eigen::SparseMatrix<double>& matrix,
                            const std::vector<int>& slices);

}  // namespace spoke::space
