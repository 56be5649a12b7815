#pragma once

// What closed loops leave of the motion of a subsystem: some of its coordinates are chosen as
// independent, and the others follow them.

#include <vector>

#include "engine/small_motions/steady/steady_model.h"
#include "engine/support/dense.h"

namespace spoke::steady {

/// The motions of a subsystem that open none of the rigid rows of its loops. With Phi these rows'
/// derivatives and y the independent coordinates, q = Z y.
class FreeMotion {
 public:
  /// Chooses the coordinates that follow: joints first, the outermost of those that move the rows
  /// well, then deformations. `rows`: the rows that count, of those of `closures`, whose columns
  /// are the coordinates. Rows that depend on others are left out.
  FreeMotion(const Eigen::MatrixXd& closures, const std::vector<Eigen::Index>& rows,
             const std::vector<SubsystemCoordinate>& coordinates);

  /// Whether all coordinates are independent.
  bool is_all() const { return dependent_.empty(); }
  /// The rows that are not left out.
  const std::vector<Eigen::Index>& rows() const { return rows_; }
  const std::vector<Eigen::Index>& independent() const { return independent_; }
  /// Returns Z.
  const Eigen::MatrixXd& basis() const { return basis_; }

  /// Returns the motions of the dependent coordinates that open the rows (in the order of rows())
  /// by these values.
  Eigen::MatrixXd open(const Eigen::MatrixXd& openings) const;
  /// Returns the forces of the rows, of all rows of the subsystem, that balance these forces on the
  /// dependent coordinates.
  Eigen::VectorXd hold(const Eigen::VectorXd& force) const;

 private:
  Eigen::Index all_rows_;
  std::vector<Eigen::Index> rows_, independent_, dependent_;
  Eigen::MatrixXd basis_;
  LuFactors by_dependent_, by_rows_;  ///< of the rows by the dependent coordinates, and transposed
};

/// Returns the numbers of the rigid rows.
std::vector<Eigen::Index> find_rigid_rows(const std::vector<ClosureRow>& rows);

}  // namespace spoke::steady
