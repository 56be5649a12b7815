#include "engine/bodies/space/solid_output.h"

#include <cassert>
#include <cmath>
#include <numeric>

namespace spoke::space {
namespace {

using Rows = NodeRecovery::Sparse;

std::vector<int> all_nodes(const SolidConstants& solid) {
  std::vector<int> nodes(solid.nodes.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

/// Returns the rows of nodes, `by_node` each.
Rows take_rows(const Rows& matrix, const std::vector<int>& nodes, int by_node) {
  Rows taken(by_node * std::ssize(nodes), matrix.cols());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (int c = 0; c < by_node; ++c)
      for (Rows::InnerIterator entry(matrix, by_node * nodes[k] + c); entry; ++entry)
        entries.emplace_back(by_node * static_cast<int>(k) + c, static_cast<int>(entry.col()),
                             entry.value());
  taken.setFromTriplets(entries.begin(), entries.end());
  return taken;
}

/// Returns the product of a row and a vector.
double multiply_row(const Rows& matrix, int row, const double* q) {
  double sum = 0.0;
  for (Rows::InnerIterator entry(matrix, row); entry; ++entry)
    sum += entry.value() * q[entry.col()];
  return sum;
}
double multiply_row(const NodeRecovery::Dense& matrix, int row, const double* q) {
  return matrix.row(row).dot(Eigen::Map<const Eigen::RowVectorXd>(q, matrix.cols()));
}

}  // namespace

double square_von_mises(const Stress& s) noexcept {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return 0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear;
}

double calc_von_mises(const Stress& stress) noexcept { return std::sqrt(square_von_mises(stress)); }

NodeRecovery::NodeRecovery(const SolidConstants& solid) : NodeRecovery(solid, all_nodes(solid)) {}

NodeRecovery::NodeRecovery(const SolidConstants& solid, const std::vector<int>& nodes)
    : size_(static_cast<int>(nodes.size())),
      coordinates_(solid.coordinates),
      has_stress_(solid.stress.rows() > 0),
      is_reduced_(solid.reduced() != nullptr) {
  Rows stress;
  if (has_stress_) stress = take_rows(solid.stress, nodes, 6);
  if (const ReducedSolid* reduced = solid.reduced()) {
    shapes_.resize(3 * size_, coordinates_);
    for (int k = 0; k < size_; ++k)
      shapes_.middleRows<3>(3 * k) =
          reduced->shapes.middleRows<3>(3 * nodes[static_cast<std::size_t>(k)]);
    if (has_stress_) stresses_ = stress * reduced->shapes;
  } else {
    const Rows Xi = solid.nodal()->Xi;
    nodal_shapes_ = take_rows(Xi, nodes, 3);
    if (has_stress_) nodal_stresses_ = stress * Xi;
  }
}

std::size_t NodeRecovery::bytes() const {
  constexpr std::size_t kEntry = sizeof(double) + sizeof(int);
  return sizeof(double) * static_cast<std::size_t>(shapes_.size() + stresses_.size()) +
         kEntry * static_cast<std::size_t>(nodal_shapes_.nonZeros() + nodal_stresses_.nonZeros());
}

Position NodeRecovery::displacement(int k, const double* q) const noexcept {
  assert(k >= 0 && k < size_);
  Position u;
  for (int c = 0; c < 3; ++c)
    u[c] = is_reduced_ ? multiply_row(shapes_, 3 * k + c, q)
                       : multiply_row(nodal_shapes_, 3 * k + c, q);
  return u;
}

Stress NodeRecovery::stress(int k, const double* q) const noexcept {
  assert(k >= 0 && k < size_ && has_stress_);
  Stress stress{};
  for (int c = 0; c < 6; ++c)
    stress[static_cast<std::size_t>(c)] = is_reduced_ ? multiply_row(stresses_, 6 * k + c, q)
                                                      : multiply_row(nodal_stresses_, 6 * k + c, q);
  return stress;
}

NodeRecovery::Largest NodeRecovery::largest_von_mises(const double* q) const noexcept {
  Largest largest;
  for (int k = 0; k < size_; ++k)
    if (const double value = von_mises(k, q); value > largest.value) largest = {value, k};
  return largest;
}

}  // namespace spoke::space
