// Puts the matrices of the subsystems and the hub together.

#include "engine/steady/linear_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/steady/alike_subsystems.h"
#include "engine/steady/derivatives.h"
#include "engine/steady/differences.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;

/// Columns of the hub's coordinates in matrices, from the derivatives of forces by its turn and
/// twist.
struct HubColumns {
  MatrixXd M, C, K;
};
HubColumns make_columns(const MatrixXd& mass, const MatrixXd& by_turn, const MatrixXd& by_twist,
                        const HubKinematics& hub) {
  return {mass, mass * hub.P1 - by_twist, mass * hub.P0 - by_turn - by_twist * hub.W};
}

/// Common quantities of subsystems that are alike: their matrices, and their coupling with all
/// components of the hub's motion, seen along the first of them.
struct Shared {
  LinearSubsystem subsystem;
  HubColumns by_hub;                      ///< rows of the subsystem's coordinates
  MatrixXd M_on_hub, C_on_hub, K_on_hub;  ///< columns of the subsystem's coordinates
  HubColumns hub;                         ///< its share in the matrices of the hub
  double effort = 0.0;                    ///< see calc_effort()
};

/// Returns the size of forces in a subsystem: the force on a coordinate consists of terms up to
/// this times the square root of its mass [sqrt(kg) m/s^2]. This bounds inertia forces m w^2 r by
/// the inequality of Cauchy and Schwarz, and other forces as far as they reach the hub.
double calc_effort(const MatrixXd& mass_of_hub, const HubVector& hub_force,
                   const SteadyModel& model) {
  const int r = model.first_rotation();
  const double spin = model.speed() * model.speed();
  const double mass = mass_of_hub(0, 0), inertia = mass_of_hub.diagonal().tail(1)[0];
  const double largest = mass_of_hub.diagonal().tail(mass_of_hub.rows() - r).maxCoeff();
  double effort = spin * std::sqrt(inertia);
  if (mass > 0.0) effort += hub_force.head(r).norm() / std::sqrt(mass);
  if (largest > 0.0) effort += hub_force.tail(hub_force.size() - r).norm() / std::sqrt(largest);
  return effort;
}

/// Returns the round-off of a subsystem's matrices.
RoundOff find_round_off(std::size_t i, const MatrixXd& mass, double effort,
                        const SteadyModel& model) {
  RoundOff found{effort * mass.diagonal().cwiseSqrt(), Eigen::VectorXd(mass.rows())};
  for (Eigen::Index k = 0; k < mass.rows(); ++k)
    found.step[k] = kStep * model.coordinates(i)[static_cast<std::size_t>(k)].scale;
  return found;
}

Shared linearize_subsystem(std::size_t i, const Equilibrium& equilibrium,
                           const HubKinematics& kinematics, SteadyModel& model) {
  const bool is_coupled = !model.free_components().empty();
  const Eigen::Index d = model.twist_size();
  const SubsystemDerivatives by =
      calc_derivatives(i, make_state(equilibrium.q[i]), is_coupled, model);
  const SubsystemMatrices matrices = model.matrices(i);
  const Eigen::Index n = by.by_q.cols();
  Shared all;
  all.subsystem.M = matrices.mass.bottomRightCorner(n, n);
  all.subsystem.C = matrices.damping - by.by_v.topRows(n);
  all.subsystem.K = model.stiffness(i) - by.by_q.topRows(n);
  SubsystemResponse response;
  model.evaluate(i, make_state(equilibrium.q[i]), model.no_offset(), response);
  all.effort = calc_effort(matrices.mass.topLeftCorner(d, d), response.hub_force, model);
  all.subsystem.round_off = find_round_off(i, all.subsystem.M, all.effort, model);
  if (!is_coupled) return all;
  const MatrixXd M_bh = matrices.mass.bottomLeftCorner(n, d);
  all.by_hub = make_columns(M_bh, by.by_turn.topRows(n), by.by_twist.topRows(n), kinematics);
  all.M_on_hub = M_bh.transpose();
  all.C_on_hub = -by.by_v.bottomRows(d);
  all.K_on_hub = -by.by_q.bottomRows(d);
  all.hub = make_columns(matrices.mass.topLeftCorner(d, d), by.by_turn.bottomRows(d),
                         by.by_twist.bottomRows(d), kinematics);
  return all;
}

/// Couples a subsystem with the hub, where `turn` takes it to the place at which `shared` was
/// found; adds its share to the hub's matrices for all components.
HubCoupling couple(const Shared& shared, const MatrixXd& turn, const std::vector<int>& free,
                   HubColumns& sum) {
  const auto columns = [&](const MatrixXd& m) { return MatrixXd((m * turn)(Eigen::all, free)); };
  const auto rows = [&](const MatrixXd& m) {
    return MatrixXd((turn.transpose() * m)(free, Eigen::all));
  };
  sum.M += turn.transpose() * shared.hub.M * turn;
  sum.C += turn.transpose() * shared.hub.C * turn;
  sum.K += turn.transpose() * shared.hub.K * turn;
  return {columns(shared.by_hub.M), columns(shared.by_hub.C), columns(shared.by_hub.K),
          rows(shared.M_on_hub),    rows(shared.C_on_hub),    rows(shared.K_on_hub)};
}

/// Derivatives of the forces on the hub itself, which are simple functions.
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
  assert(equilibrium.q.size() == model.subsystems() &&
         equilibrium.alike.size() == model.subsystems());
  const std::vector<int>& free = model.free_components();
  const HubKinematics kinematics = make_hub_kinematics(model);
  HubColumns hub = linearize_hub(kinematics, model);
  LinearModel result;
  result.subsystems.resize(model.subsystems());
  result.alike = equilibrium.alike;
  if (!free.empty()) result.alike = find_alike_about_hub(equilibrium.alike, equilibrium.q, model);
  result.rate = std::max(1.0, std::abs(model.speed()));
  const double of_hub = calc_effort(model.hub_mass(), model.hub_force(model.no_offset()), model);
  double squares = of_hub * of_hub;
  std::vector<Shared> shared(model.subsystems());
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::size_t first = result.alike[i];
    if (first == i) {
      shared[i] = linearize_subsystem(i, equilibrium, kinematics, model);
      result.subsystems[i] = std::move(shared[i].subsystem);
    }
    if (free.empty()) continue;
    const MatrixXd turn = turn_hub(model.azimuth(first) - model.azimuth(i), model);
    result.couplings.push_back(couple(shared[first], turn, free, hub));
    squares += shared[first].effort * shared[first].effort;
  }
  result.M = hub.M(free, free);
  result.C = hub.C(free, free);
  result.K = hub.K(free, free);
  result.round_off = {std::sqrt(squares) * result.M.diagonal().cwiseSqrt(),
                      Eigen::VectorXd::Constant(result.M.rows(), kStep)};
  return result;
}

}  // namespace spoke::steady
