#include "models/space/solid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace spoke::space {
namespace {

/// The axes of the products of w: yz, xz, xy.
constexpr int kFirst[] = {1, 0, 0}, kSecond[] = {2, 2, 1};

}  // namespace

Matrix3 spin_matrix(int k) {
  assert(k >= 0 && k < kSpins);
  Matrix3 A = Matrix3::Zero();
  if (k < 3) {
    A(k, k) = 1.0;
    return A - Matrix3::Identity();
  }
  A(kFirst[k - 3], kSecond[k - 3]) = A(kSecond[k - 3], kFirst[k - 3]) = 1.0;
  return A;
}

std::array<double, kSpins> spin_monomials(const Angular& w) {
  return {w[0] * w[0], w[1] * w[1], w[2] * w[2], w[1] * w[2], w[0] * w[2], w[0] * w[1]};
}

SolidPlace make_node_place(const SolidConstants& constants, int node) {
  assert(node >= 0 && std::cmp_less(node, constants.nodes.size()));
  SolidPlace place;
  place.p = constants.nodes[static_cast<std::size_t>(node)];
  for (int k = 0; k < constants.coordinates; ++k) {
    Position u = Position::Zero();
    if (const ReducedSolid* reduced = constants.reduced())
      u = reduced->shapes.col(k).segment<3>(3 * node);
    else
      for (NodalSolid::Sparse::InnerIterator it(constants.nodal()->Xi, k); it; ++it)
        if (it.row() / 3 == node) u[it.row() % 3] = it.value();
    if (u.isZero(0.0)) continue;
    place.at.push_back(k);
    place.columns.push_back(make_twist(u, Angular::Zero()));
  }
  return place;
}

namespace {

/// Returns Xi^T (m 1 (x) 1_3).
Eigen::MatrixXd calc_C_t(const NodalSolid& solid) {
  const Eigen::VectorXd me = solid.m * Eigen::VectorXd::Ones(solid.m.cols());
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(3 * me.size(), 3);
  for (Eigen::Index i = 0; i < me.size(); ++i)
    moved.middleRows<3>(3 * i) = me[i] * Eigen::Matrix3d::Identity();
  return solid.Xi.transpose() * moved;
}

std::vector<double> find_limits(const SolidConstants& constants) {
  std::vector<double> limits;
  for (int k = 0; k < constants.coordinates; ++k) {
    double largest = 0.0;
    if (const ReducedSolid* reduced = constants.reduced())
      largest = reduced->shapes.col(k).cwiseAbs().maxCoeff();
    else
      for (NodalSolid::Sparse::InnerIterator it(constants.nodal()->Xi, k); it; ++it)
        largest = std::max(largest, std::abs(it.value()));
    limits.push_back(constants.extent / largest);
  }
  return limits;
}

/// Returns the strains of the nodes at which those of any mode are largest.
Eigen::MatrixXd find_strains(const SolidConstants& constants) {
  const ReducedSolid* reduced = constants.reduced();
  if (!reduced || constants.stress.rows() == 0 || !(constants.youngs_modulus > 0.0)) return {};
  const Eigen::MatrixXd all = constants.stress * reduced->shapes / constants.youngs_modulus;
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index k = 0; k < all.cols(); ++k) {
    Eigen::Index row = 0;
    all.col(k).cwiseAbs().maxCoeff(&row);
    chosen.push_back(row / 6);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Eigen::MatrixXd strains(6 * static_cast<Eigen::Index>(chosen.size()), all.cols());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    strains.middleRows(6 * static_cast<Eigen::Index>(i), 6) = all.middleRows(6 * chosen[i], 6);
  return strains;
}

void set_tip(SolidConstants& constants) {
  if (constants.interfaces > 1) {
    constants.tip_number = constants.interfaces - 1;
    constants.tip = constants.places[static_cast<std::size_t>(constants.tip_number)];
    return;
  }
  const auto farthest =
      std::max_element(constants.nodes.begin(), constants.nodes.end(),
                       [](const Position& a, const Position& b) { return a.norm() < b.norm(); });
  assert(farthest != constants.nodes.end());
  constants.tip = make_node_place(constants, static_cast<int>(farthest - constants.nodes.begin()));
}

}  // namespace

void set_derived(SolidConstants& constants) {
  if (auto* nodal = std::get_if<NodalSolid>(&constants.matrices)) nodal->C_t = calc_C_t(*nodal);
  constants.limits = find_limits(constants);
  constants.least_limit = *std::min_element(constants.limits.begin(), constants.limits.end());
  constants.strain_modes = find_strains(constants);
  set_tip(constants);
}

double calc_stiffness_trace(const SolidConstants& constants) {
  if (const ReducedSolid* reduced = constants.reduced()) return reduced->stiffness.sum();
  return constants.nodal()->K.diagonal().sum();
}

Eigen::VectorXd calc_displacements(const SolidConstants& constants, const double* q) {
  const Eigen::Map<const Eigen::VectorXd> coordinates(q, constants.coordinates);
  if (const ReducedSolid* reduced = constants.reduced()) return reduced->shapes * coordinates;
  return constants.nodal()->Xi * coordinates;
}

std::string name_coordinate(const SolidConstants& constants, int coordinate) {
  assert(coordinate >= 0 && coordinate < constants.coordinates);
  return (constants.reduced() ? "mode " : "coordinate ") + std::to_string(coordinate + 1);
}

}  // namespace spoke::space
