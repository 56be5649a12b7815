// Pairs with the largest sum, against all permutations.

#include "engine/small_motions/vibration/assignment.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

double sum_of(const MatrixXd& gains, const std::vector<Index>& column_of) {
  double sum = 0.0;
  for (std::size_t row = 0; row < column_of.size(); ++row)
    if (column_of[row] >= 0) sum += gains(static_cast<Index>(row), column_of[row]);
  return sum;
}

/// Returns the largest sum over all ways to pair the rows, of which there are not more than
/// columns.
double largest_sum(const MatrixXd& gains) {
  std::vector<Index> columns(static_cast<std::size_t>(gains.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  double largest = -1e300;
  do {
    largest = std::max(largest, sum_of(gains, {columns.begin(), columns.begin() + gains.rows()}));
  } while (std::next_permutation(columns.begin(), columns.end()));
  return largest;
}

TEST_CASE("assignment: no way to pair rows and columns has a larger sum") {
  std::mt19937 dice{7};
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const auto& [rows, columns] : {std::pair{1, 1}, {3, 3}, {5, 5}, {2, 5}, {6, 6}, {4, 6}})
    for (int k = 0; k < 20; ++k) {
      const MatrixXd gains = MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(dice); });
      const std::vector<Index> found = find_best_assignment(gains);
      CHECK(sum_of(gains, found) == doctest::Approx(largest_sum(gains)));
      std::vector<Index> sorted = found;
      std::sort(sorted.begin(), sorted.end());
      CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
      // With more rows than columns, some have none.
      const std::vector<Index> tall = find_best_assignment(gains.transpose());
      CHECK(std::count(tall.begin(), tall.end(), -1) == columns - rows);
      CHECK(sum_of(gains.transpose(), tall) == doctest::Approx(largest_sum(gains)));
    }
  // Greedily (10 first) the sum would be 11.
  MatrixXd trap(2, 2);
  trap << 10.0, 9.0, 9.0, 1.0;
  CHECK(find_best_assignment(trap) == std::vector<Index>{1, 0});
  CHECK(find_best_assignment(MatrixXd(0, 3)).empty());
}

}  // namespace
}  // namespace spoke::vibration
