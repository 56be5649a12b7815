#pragma once

// Which rows of a Jacobian are redundant, and whether what is prescribed fights them.

#include <Eigen/Core>
#include <vector>

namespace spoke {

/// Result of eliminating rows by one another.
struct RowRank {
  std::vector<bool> is_redundant;  ///< by row
  /// By row, for redundant ones: what is left of the row of `given`, which the same combination of
  /// other rows is taken off.
  Eigen::MatrixXd left;
  /// Likewise the largest magnitudes of what was combined.
  Eigen::MatrixXd sizes;
};

/// Takes the rows in the order of what is left of them by those taken before, of nearly equal ones
/// the first; a row of which less than `redundancy` of the largest row is left is redundant.
/// `given`: as many rows, of any number of columns.
RowRank find_redundant_rows(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& given,
                            double redundancy);

}  // namespace spoke
