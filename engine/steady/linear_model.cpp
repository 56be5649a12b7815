// Puts the matrices of the trees and the hub together.

#include "engine/steady/linear_model.h"

#include "engine/steady/derivatives.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;

/// Forces' derivatives by the hub's turn and twist, to matrices of its coordinates.
struct HubColumns {
  MatrixXd M, C, K;
};
HubColumns make_columns(const MatrixXd& mass, const MatrixXd& by_turn, const MatrixXd& by_twist,
                        const HubKinematics& hub) {
  return {mass, mass * hub.P1 - by_twist, mass * hub.P0 - by_turn - by_twist * hub.W};
}

MatrixXd select_columns(const MatrixXd& m, const std::vector<int>& free) {
  return m(Eigen::all, free);
}
MatrixXd select_rows(const MatrixXd& m, const std::vector<int>& free) {
  return m(free, Eigen::all);
}

/// Linearises tree `i`, and adds its share to the hub's matrices, of all components.
LinearTree linearize_tree(std::size_t i, const Equilibrium& equilibrium, const HubKinematics& hub,
                          SteadyModel& model, HubColumns& sum) {
  const std::vector<int>& free = model.free_components();
  const bool is_coupled = !free.empty();
  const Eigen::Index d = model.twist_size();
  const TreeDerivatives by = calc_derivatives(i, make_state(equilibrium.q[i]), is_coupled, model);
  const TreeMatrices matrices = model.matrices(i);
  const Eigen::Index n = by.by_q.cols();
  LinearTree tree;
  tree.M = matrices.mass.bottomRightCorner(n, n);
  tree.C = matrices.damping - by.by_v.topRows(n);
  tree.K = model.stiffness(i) - by.by_q.topRows(n);
  if (!is_coupled) return tree;
  const MatrixXd M_bh = matrices.mass.bottomLeftCorner(n, d);
  const HubColumns column = make_columns(M_bh, by.by_turn.topRows(n), by.by_twist.topRows(n), hub);
  tree.M_bh = select_columns(column.M, free);
  tree.C_bh = select_columns(column.C, free);
  tree.K_bh = select_columns(column.K, free);
  tree.M_hb = select_rows(M_bh.transpose(), free);
  tree.C_hb = select_rows(-by.by_v.bottomRows(d), free);
  tree.K_hb = select_rows(-by.by_q.bottomRows(d), free);
  const HubColumns own = make_columns(matrices.mass.topLeftCorner(d, d), by.by_turn.bottomRows(d),
                                      by.by_twist.bottomRows(d), hub);
  sum.M += own.M;
  sum.C += own.C;
  sum.K += own.K;
  return tree;
}

/// Derivatives of what acts on the hub itself; these are simple functions.
HubColumns linearize_hub(const HubKinematics& kinematics, const SteadyModel& model) {
  constexpr double kStep = 1e-4;
  const Eigen::Index d = model.twist_size();
  MatrixXd by_turn = MatrixXd::Zero(d, d), by_twist = MatrixXd::Zero(d, d);
  for (Eigen::Index c = 0; c < d; ++c) {
    const auto differ = [&](HubVector HubOffset::*member) {
      HubOffset plus = model.no_offset(), minus = plus;
      (plus.*member)[c] = kStep;
      (minus.*member)[c] = -kStep;
      return HubVector((model.hub_force(plus) - model.hub_force(minus)) / (2.0 * kStep));
    };
    if (c >= model.first_rotation()) by_turn.col(c) = differ(&HubOffset::turn);
    by_twist.col(c) = differ(&HubOffset::twist);
  }
  return make_columns(model.hub_mass(), by_turn, by_twist, kinematics);
}

}  // namespace

HubKinematics make_hub_kinematics(const SteadyModel& model) {
  const Eigen::Index d = model.twist_size();
  HubKinematics hub{MatrixXd::Zero(d, d), MatrixXd::Zero(d, d), MatrixXd::Zero(d, d)};
  Eigen::Matrix2d cross;
  cross << 0.0, -model.speed(), model.speed(), 0.0;
  hub.W.topLeftCorner<2, 2>() = cross;
  hub.P1.topLeftCorner<2, 2>() = 2.0 * cross;
  hub.P0.topLeftCorner<2, 2>() = cross * cross;
  if (!model.is_spatial()) return hub;
  hub.W.block<2, 2>(3, 3) = cross;
  hub.P1.block<2, 2>(3, 3) = cross;
  return hub;
}

LinearModel linearize(const Equilibrium& equilibrium, SteadyModel& model) {
  const std::vector<int>& free = model.free_components();
  const HubKinematics kinematics = make_hub_kinematics(model);
  HubColumns hub = linearize_hub(kinematics, model);
  LinearModel result;
  result.trees.resize(model.trees());
  result.alike.resize(model.trees());
  for (std::size_t i = 0; i < model.trees(); ++i) {
    result.alike[i] = free.empty() ? equilibrium.alike[i] : i;
    if (result.alike[i] == i)
      result.trees[i] = linearize_tree(i, equilibrium, kinematics, model, hub);
  }
  result.M = hub.M(free, free);
  result.C = hub.C(free, free);
  result.K = hub.K(free, free);
  return result;
}

}  // namespace spoke::steady
