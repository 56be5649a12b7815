// Chooses coordinates by pivoting, and eliminates them.

#include "engine/small_motions/steady/free_motion.h"

#include <algorithm>
#include <cassert>

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A joint counts if it moves a row by this share of what all coordinates do; one that moves it by
/// kShare of the most is preferred if it stands further out.
constexpr double kNotable = 1e-3, kShare = 0.1;
/// Below this share of a row's motion the rest is round-off: the row depends on others.
constexpr double kRank = 1e-9;

/// Projects columns one by one out of the others.
class Elimination {
 public:
  explicit Elimination(MatrixXd columns) : left_(std::move(columns)) {}

  double size(Index column) const { return left_.col(column).norm(); }
  void take(Index column) {
    const VectorXd direction = left_.col(column).normalized();
    for (int twice = 0; twice < 2; ++twice)
      left_ -= direction * (direction.transpose() * left_).eval();
    left_.col(column).setZero();
  }

 private:
  MatrixXd left_;
};

/// Returns the column to eliminate next; -1: nothing is left.
Index choose(const Elimination& left, const std::vector<SubsystemCoordinate>& coordinates) {
  double most_of_joints = 0.0, most = 0.0;
  Index best = -1;
  for (Index k = 0; k < std::ssize(coordinates); ++k) {
    const double size = left.size(k);
    if (coordinates[static_cast<std::size_t>(k)].node < 0)
      most_of_joints = std::max(most_of_joints, size);
    if (size > most) {
      most = size;
      best = k;
    }
  }
  if (!(most > kRank)) return -1;
  if (most_of_joints < kNotable) return best;
  for (Index k = std::ssize(coordinates); k-- > 0;)
    if (coordinates[static_cast<std::size_t>(k)].node < 0 &&
        left.size(k) >= kShare * most_of_joints)
      return k;
  return best;
}

/// Returns rows scaled to length one, by coordinates of like size; rows of zero stay.
MatrixXd scale(MatrixXd rows, const std::vector<SubsystemCoordinate>& coordinates) {
  for (Index k = 0; k < rows.cols(); ++k)
    rows.col(k) *= coordinates[static_cast<std::size_t>(k)].scale;
  for (Index r = 0; r < rows.rows(); ++r) rows.row(r).normalize();
  return rows;
}

}  // namespace

FreeMotion::FreeMotion(const MatrixXd& closures, const std::vector<Index>& rows,
                       const std::vector<SubsystemCoordinate>& coordinates)
    : all_rows_(closures.rows()) {
  const Index n = std::ssize(coordinates);
  assert(closures.cols() == n);
  const MatrixXd scaled = scale(closures(rows, Eigen::all), coordinates);
  Elimination columns(scaled);
  for (Index k = choose(columns, coordinates); k >= 0 && dependent_.size() < rows.size();
       k = choose(columns, coordinates)) {
    dependent_.push_back(k);
    columns.take(k);
  }
  std::sort(dependent_.begin(), dependent_.end());
  for (Index k = 0; k < n; ++k)
    if (!std::binary_search(dependent_.begin(), dependent_.end(), k)) independent_.push_back(k);
  const Index rank = std::ssize(dependent_);
  Elimination left(MatrixXd(scaled(Eigen::all, dependent_)).transpose());
  while (std::ssize(rows_) < rank) {
    std::size_t best = 0;
    for (std::size_t r = 1; r < rows.size(); ++r)
      if (left.size(static_cast<Index>(r)) > left.size(static_cast<Index>(best))) best = r;
    rows_.push_back(rows[best]);
    left.take(static_cast<Index>(best));
  }
  std::sort(rows_.begin(), rows_.end());
  basis_ = MatrixXd::Zero(n, n - rank);
  for (Index k = 0; k < n - rank; ++k) basis_(independent_[static_cast<std::size_t>(k)], k) = 1.0;
  if (rank == 0) return;
  const MatrixXd of_rows = closures(rows_, Eigen::all);
  const MatrixXd by_dependent = of_rows(Eigen::all, dependent_);
  by_dependent_.compute(by_dependent);
  by_rows_.compute(by_dependent.transpose());
  if (n > rank)
    basis_(dependent_, Eigen::all) =
        -by_dependent_.solve(MatrixXd(of_rows(Eigen::all, independent_)));
}

MatrixXd FreeMotion::open(const MatrixXd& openings) const {
  assert(openings.rows() == std::ssize(rows_));
  MatrixXd motion = MatrixXd::Zero(basis_.rows(), openings.cols());
  if (!is_all() && openings.cols() > 0)
    motion(dependent_, Eigen::all) = by_dependent_.solve(openings);
  return motion;
}

VectorXd FreeMotion::hold(const VectorXd& force) const {
  VectorXd multipliers = VectorXd::Zero(all_rows_);
  if (!is_all()) multipliers(rows_) = -by_rows_.solve(MatrixXd(VectorXd(force(dependent_)))).col(0);
  return multipliers;
}

std::vector<Index> find_rigid_rows(const std::vector<ClosureRow>& rows) {
  std::vector<Index> rigid;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].is_rigid()) rigid.push_back(static_cast<Index>(r));
  return rigid;
}

}  // namespace spoke::steady
