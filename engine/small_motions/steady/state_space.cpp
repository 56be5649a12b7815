// Collects the entries of matrices, and names the hub's motion.

#include "engine/small_motions/steady/state_space.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::Index;

/// Names of a component of the hub's motion and of its force.
struct HubNames {
  const char *coordinate, *effort;
};
HubNames name_component(int c, const SteadyModel& model) {
  static constexpr HubNames kMoves[] = {{"x", "force x"}, {"y", "force y"}, {"z", "force z"}};
  static constexpr HubNames kTurns[] = {{"rotation x", "moment x"}, {"rotation y", "moment y"}};
  if (c == model.twist_size() - 1) return {"angle", "torque"};
  return c < model.first_rotation() ? kMoves[c] : kTurns[c - model.first_rotation()];
}

bool is_rotation(int c, const SteadyModel& model) { return c >= model.first_rotation(); }

}  // namespace

void MatrixEntries::add(Index row, Index column, const Eigen::MatrixXd& block) {
  for (Index c = 0; c < block.cols(); ++c)
    for (Index r = 0; r < block.rows(); ++r)
      if (block(r, c) != 0.0) list_.emplace_back(row + r, column + c, block(r, c));
}

void MatrixEntries::add(Index row, const std::vector<Index>& rows, Index column,
                        const std::vector<Index>& columns, const Eigen::MatrixXd& block) {
  assert(block.rows() == std::ssize(rows) && block.cols() == std::ssize(columns));
  for (Index c = 0; c < block.cols(); ++c)
    for (Index r = 0; r < block.rows(); ++r)
      if (block(r, c) != 0.0)
        list_.emplace_back(row + rows[static_cast<std::size_t>(r)],
                           column + columns[static_cast<std::size_t>(c)], block(r, c));
}

Eigen::SparseMatrix<double> MatrixEntries::matrix(Index rows, Index columns) const {
  Eigen::SparseMatrix<double> made(rows, columns);
  made.setFromTriplets(list_.begin(), list_.end());
  return made;
}

LinearSignal name_hub_motion(std::size_t hub, int c, const SteadyModel& model) {
  return {model.prefix_of(hub) + "hub / " + name_component(c, model).coordinate,
          is_rotation(c, model) ? "rad" : "m"};
}

LinearSignal name_hub_effort(std::size_t hub, int c, const SteadyModel& model) {
  return {model.prefix_of(hub) + "hub / " + name_component(c, model).effort,
          is_rotation(c, model) ? "N m" : "N"};
}

LinearSignal name_drive_torque(std::size_t hub, const SteadyModel& model) {
  return {model.prefix_of(hub) + "axle / torque", "N m"};
}

std::vector<LinearSignal> name_hub_states(const LinearModel& linear, const SteadyModel& model) {
  std::vector<LinearSignal> states;
  if (const auto& support = linear.support)
    for (std::size_t k = 0; k < support->names.size(); ++k)
      states.push_back({support->names[k], support->units[k]});
  else
    for (const int c : model.free_components()) states.push_back(name_hub_motion(0, c, model));
  return states;
}

LinearSignal rate_of(const LinearSignal& signal) {
  return {"rate of " + signal.name, signal.unit + "/s"};
}

namespace {

/// Returns the matrix that picks these of `size` rows.
Eigen::SparseMatrix<double> pick(const std::vector<Index>& rows, Index size) {
  MatrixEntries picked;
  for (std::size_t k = 0; k < rows.size(); ++k)
    picked.add(static_cast<Index>(k), rows[k], Eigen::MatrixXd::Ones(1, 1));
  return picked.matrix(std::ssize(rows), size);
}

}  // namespace

void take_out_rates(std::vector<Index> forces, LinearSystem& system) {
  if (forces.empty()) return;
  using Sparse = Eigen::SparseMatrix<double>;
  const Index states = system.A.rows();
  std::sort(forces.begin(), forces.end());
  for (Index& k : forces) k += states / 2;
  std::vector<Index> kept;
  std::vector<LinearSignal> names;
  for (Index k = 0; k < states; ++k) {
    if (std::binary_search(forces.begin(), forces.end(), k)) continue;
    kept.push_back(k);
    names.push_back(system.states[static_cast<std::size_t>(k)]);
  }
  const Sparse keep = pick(kept, states), rates = pick(forces, states);
  // Rates r of next to no mass: 0 = R_r r + R_x x + R_u u.
  const Sparse rows = rates * system.A;
  const LuFactors own{Eigen::MatrixXd(rows * rates.transpose())};
  const Eigen::MatrixXd by_x = -own.solve(Eigen::MatrixXd(rows * keep.transpose()));
  const Sparse all_by_x =
      Sparse(keep.transpose()) + Sparse(rates.transpose()) * Sparse(by_x.sparseView());
  Sparse all_by_u(states, system.B.cols());
  if (system.B.cols() > 0)
    all_by_u = Sparse(rates.transpose()) *
               Sparse(Eigen::MatrixXd(-own.solve(Eigen::MatrixXd(rates * system.B))).sparseView());
  system.D += Sparse(system.C * all_by_u);
  system.C = (system.C * all_by_x).eval();
  system.B = keep * Sparse(system.B + system.A * all_by_u);
  system.A = keep * Sparse(system.A * all_by_x);
  system.states = std::move(names);
}

void require_few_coupled(Index coordinates) {
  if (coordinates > kMostCoupled)
    throw InputError("blades couple through the hub and have " + std::to_string(coordinates) +
                     " coordinates, expected at most " + std::to_string(kMostCoupled) +
                     ": the matrices would be full");
}

}  // namespace spoke::steady
