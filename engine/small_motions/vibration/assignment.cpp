// Finds shortest augmenting paths, row by row.

#include "engine/small_motions/vibration/assignment.h"

#include <limits>

namespace spoke::vibration {
namespace {

using Eigen::Index;

/// Pairs of a matrix of costs with at most as many rows as columns, grown by one row at a time.
class Pairs {
 public:
  explicit Pairs(const Eigen::MatrixXd& costs)
      : costs_(costs),
        row_price_(Eigen::VectorXd::Zero(costs.rows())),
        column_price_(Eigen::VectorXd::Zero(costs.cols())),
        row_of_(static_cast<std::size_t>(costs.cols()), -1) {}

  /// Pairs a further row: other rows give way along the path that costs least.
  void add(Index row) {
    const auto columns = row_of_.size();
    std::vector<double> distance(columns, std::numeric_limits<double>::infinity());
    std::vector<Index> before(columns, -1);  // column that the path comes from
    std::vector<bool> is_reached(columns);
    Index from = -1, at = row;
    double length = 0.0;
    while (true) {
      for (std::size_t j = 0; j < columns; ++j) {
        const auto column = static_cast<Index>(j);
        const double next = length + reduced(at, column);
        if (is_reached[j] || !(next < distance[j])) continue;
        distance[j] = next;
        before[j] = from;
      }
      from = find_nearest(distance, is_reached);
      is_reached[static_cast<std::size_t>(from)] = true;
      length = distance[static_cast<std::size_t>(from)];
      at = row_of_[static_cast<std::size_t>(from)];
      if (at < 0) break;
    }
    update_prices(row, length, distance, is_reached);
    for (Index column = from; column >= 0;) {
      const Index previous = before[static_cast<std::size_t>(column)];
      row_of_[static_cast<std::size_t>(column)] =
          previous < 0 ? row : row_of_[static_cast<std::size_t>(previous)];
      column = previous;
    }
  }

  const std::vector<Index>& row_of() const { return row_of_; }

 private:
  double reduced(Index row, Index column) const {
    return costs_(row, column) - row_price_[row] - column_price_[column];
  }

  static Index find_nearest(const std::vector<double>& distance,
                            const std::vector<bool>& is_reached) {
    Index nearest = -1;
    for (std::size_t j = 0; j < distance.size(); ++j)
      if (!is_reached[j] &&
          (nearest < 0 || distance[j] < distance[static_cast<std::size_t>(nearest)]))
        nearest = static_cast<Index>(j);
    return nearest;
  }

  /// Keeps reduced costs from being negative, and those of pairs at zero.
  void update_prices(Index row, double length, const std::vector<double>& distance,
                     const std::vector<bool>& is_reached) {
    row_price_[row] += length;
    for (std::size_t j = 0; j < distance.size(); ++j) {
      if (!is_reached[j]) continue;
      const double less = length - distance[j];
      column_price_[static_cast<Index>(j)] -= less;
      if (row_of_[j] >= 0) row_price_[row_of_[j]] += less;
    }
  }

  const Eigen::MatrixXd& costs_;
  Eigen::VectorXd row_price_, column_price_;
  std::vector<Index> row_of_;  ///< by column; -1: none
};

}  // namespace

std::vector<Eigen::Index> find_best_assignment(const Eigen::MatrixXd& gains) {
  const bool is_wide = gains.rows() <= gains.cols();
  const Eigen::MatrixXd costs =
      is_wide ? Eigen::MatrixXd(-gains) : Eigen::MatrixXd(-gains.transpose());
  Pairs pairs(costs);
  for (Index row = 0; row < costs.rows(); ++row) pairs.add(row);
  if (!is_wide) return pairs.row_of();
  std::vector<Index> column_of(static_cast<std::size_t>(gains.rows()), -1);
  for (std::size_t column = 0; column < pairs.row_of().size(); ++column)
    if (const Index row = pairs.row_of()[column]; row >= 0)
      column_of[static_cast<std::size_t>(row)] = static_cast<Index>(column);
  return column_of;
}

}  // namespace spoke::vibration
