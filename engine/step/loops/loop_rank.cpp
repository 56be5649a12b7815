// Orthogonalises rows, the largest first.

#include "engine/step/loops/loop_rank.h"

#include <cassert>

namespace spoke {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows that are left, with what goes along.
struct Rest {
  Rows rows, given, sizes;

  /// Takes off what a row has of a unit row.
  void subtract(Eigen::Index row, Eigen::Index unit) {
    const double share = rows.row(row).dot(rows.row(unit));
    if (share == 0.0) return;
    rows.row(row) -= share * rows.row(unit);
    given.row(row) -= share * given.row(unit);
    sizes.row(row) = sizes.row(row).cwiseMax(std::abs(share) * sizes.row(unit));
  }
};

Eigen::Index find_largest(const Eigen::VectorXd& lengths, const std::vector<bool>& is_taken) {
  constexpr double kNearly = 1e-6;
  Eigen::Index largest = -1;
  double most = 0.0;
  for (Eigen::Index r = 0; r < lengths.size(); ++r) {
    if (is_taken[static_cast<std::size_t>(r)]) continue;
    if (largest >= 0 && lengths[r] <= (1.0 + kNearly) * most) continue;
    largest = r;
    most = lengths[r];
  }
  return largest;
}

}  // namespace

RowRank find_redundant_rows(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& given,
                            double redundancy) {
  assert(rows.rows() == given.rows() && redundancy > 0.0);
  const Eigen::Index count = rows.rows();
  Rest rest{rows, given, given.cwiseAbs()};
  Eigen::VectorXd lengths = rest.rows.rowwise().norm();
  std::vector<bool> is_taken(static_cast<std::size_t>(count), false);
  std::vector<Eigen::Index> taken;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index next = find_largest(lengths, is_taken);
    // Twice is enough: what round-off has left of the rows before goes, too.
    for (const Eigen::Index unit : taken) rest.subtract(next, unit);
    const double size = rest.rows.row(next).norm();
    if (k == 0) largest = size;
    if (!(size > redundancy * largest)) break;
    is_taken[static_cast<std::size_t>(next)] = true;
    rest.rows.row(next) /= size;
    rest.given.row(next) /= size;
    rest.sizes.row(next) /= size;
    taken.push_back(next);
    for (Eigen::Index r = 0; r < count; ++r) {
      if (is_taken[static_cast<std::size_t>(r)]) continue;
      rest.subtract(r, next);
      lengths[r] = rest.rows.row(r).norm();
    }
  }
  is_taken.flip();
  return {is_taken, rest.given, rest.sizes};
}

}  // namespace spoke
