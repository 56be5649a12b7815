// A skyline against dense matrices, and orders by which it is low.

#include "engine/support/skyline.h"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <random>

using namespace spoke;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Random first columns of rows.
std::vector<int> make_first(int rows, std::mt19937& random) {
  std::vector<int> first;
  for (int r = 0; r < rows; ++r)
    first.push_back(std::max(0, r - std::uniform_int_distribution<int>(0, 5)(random)));
  first.back() = 0;
  return first;
}

/// A random positive definite matrix with these first columns.
MatrixXd make_matrix(const std::vector<int>& first, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto rows = static_cast<Eigen::Index>(first.size());
  MatrixXd matrix = MatrixXd::Zero(rows, rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    for (Eigen::Index c = first[static_cast<std::size_t>(r)]; c < r; ++c)
      matrix(r, c) = matrix(c, r) = unit(random);
    matrix(r, r) = 30.0;
  }
  return matrix;
}

void fill(const MatrixXd& matrix, Skyline& skyline) {
  for (int r = 0; r < skyline.rows(); ++r)
    for (int c = skyline.first(r); c <= r; ++c) skyline.entry(r, c) = matrix(r, c);
}

using Graph = std::vector<std::vector<int>>;

Graph make_graph(int nodes, const std::vector<std::pair<int, int>>& edges) {
  Graph graph(static_cast<std::size_t>(nodes));
  for (const auto& [a, b] : edges) {
    graph[static_cast<std::size_t>(a)].push_back(b);
    graph[static_cast<std::size_t>(b)].push_back(a);
  }
  return graph;
}

/// Returns the farthest that two neighbours come to lie from one another.
int find_width(const Graph& graph, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  int width = 0;
  for (std::size_t a = 0; a < graph.size(); ++a)
    for (const int b : graph[a])
      width = std::max(width, std::abs(place[a] - place[static_cast<std::size_t>(b)]));
  return width;
}

std::vector<int> as_numbered(int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

}  // namespace

TEST_CASE("a skyline is factorised as a dense matrix is, and solves") {
  std::mt19937 random(4);
  for (const int rows : {1, 2, 7, 30}) {
    Arena arena;
    const std::vector<int> first = make_first(rows, random);
    const MatrixXd matrix = make_matrix(first, random);
    Skyline skyline(first, arena);
    fill(matrix, skyline);
    std::vector<double> pivots(first.size());
    skyline.factorise(pivots, rows);
    const MatrixXd L = matrix.llt().matrixL();
    for (int r = 0; r < rows; ++r) {
      CHECK(pivots[static_cast<std::size_t>(r)] == doctest::Approx(L(r, r) * L(r, r)));
      for (int c = 0; c <= r; ++c) {
        if (c < skyline.first(r))
          CHECK(L(r, c) == 0.0);
        else
          CHECK(skyline.entry(r, c) == doctest::Approx(L(r, c)));
      }
    }
    const VectorXd right = VectorXd::LinSpaced(rows, 1.0, 2.0);
    std::vector<double> x(right.begin(), right.end());
    skyline.solve_lower(x, rows);
    skyline.solve_upper(x, rows);
    const VectorXd found = Eigen::Map<const VectorXd>(x.data(), rows);
    CHECK((matrix * found - right).norm() < 1e-13 * right.norm() * rows);
  }
}

TEST_CASE("the rows behind the first ones keep their Schur complement") {
  std::mt19937 random(6);
  constexpr int kRows = 12, kFirst = 8, kLast = kRows - kFirst;
  Arena arena;
  const std::vector<int> first = make_first(kRows, random);
  const MatrixXd matrix = make_matrix(first, random);
  Skyline skyline(first, arena);
  fill(matrix, skyline);
  std::vector<double> pivots(kRows);
  skyline.factorise(pivots, kFirst);
  const MatrixXd A = matrix.topLeftCorner(kFirst, kFirst),
                 B = matrix.bottomLeftCorner(kLast, kFirst);
  const MatrixXd S = matrix.bottomRightCorner(kLast, kLast) - B * A.llt().solve(B.transpose());
  for (int r = 0; r < kLast; ++r)
    for (int c = 0; c <= r; ++c)
      CHECK(skyline.value(kFirst + r, kFirst + c) == doctest::Approx(S(r, c)).epsilon(1e-12));
  // Where the last values are given, the first follow.
  const VectorXd right = VectorXd::LinSpaced(kRows, 1.0, 2.0),
                 given = VectorXd::LinSpaced(kLast, -1.0, 3.0);
  std::vector<double> x(right.begin(), right.end());
  skyline.solve_lower(x, kFirst);
  const VectorXd handed = Eigen::Map<const VectorXd>(x.data() + kFirst, kLast);
  CHECK((handed - (right.tail(kLast) - B * A.llt().solve(right.head(kFirst)))).norm() < 1e-12);
  std::copy(given.begin(), given.end(), x.begin() + kFirst);
  skyline.solve_upper(x, kFirst);
  const VectorXd found = Eigen::Map<const VectorXd>(x.data(), kFirst);
  CHECK((A * found + B.transpose() * given - right.head(kFirst)).norm() < 1e-12);
}

TEST_CASE("a pivot that vanishes is told, and replaced") {
  Arena arena;
  Skyline skyline({0, 0}, arena);
  for (const auto& [r, c] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1)})
    skyline.entry(r, c) = 4.0;
  std::vector<double> pivots(2);
  skyline.factorise(pivots, 2);
  CHECK(pivots == std::vector<double>{4.0, 0.0});
  CHECK(skyline.entry(1, 1) == 2.0);
  skyline.set_zero();
  CHECK(std::all_of(skyline.values().begin(), skyline.values().end(),
                    [](double value) { return value == 0.0; }));
}

TEST_CASE("a chain of nodes that is numbered at random is ordered along itself") {
  constexpr int kNodes = 60;
  std::mt19937 random(5);
  std::vector<int> number = as_numbered(kNodes);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<std::pair<int, int>> edges;
  for (std::size_t k = 0; k + 1 < number.size(); ++k)
    if (k != 20) edges.emplace_back(number[k], number[k + 1]);  // two parts
  const Graph graph = make_graph(kNodes, edges);
  const std::vector<int> order = find_low_order(graph, std::vector<int>(kNodes, 3));
  CHECK(find_width(graph, order) == 1);
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  CHECK(sorted == as_numbered(kNodes));
}

TEST_CASE("an order that is as good as any stays") {
  CHECK(find_low_order({}, {}).empty());
  const Graph chain = make_graph(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  CHECK(find_low_order(chain, {3, 3, 3, 3, 3}) == as_numbered(5));
  const Graph all = make_graph(3, {{0, 1}, {1, 2}, {0, 2}});
  CHECK(find_low_order(all, {2, 2, 2}) == as_numbered(3));
}
