// Takes central differences of the forces that the step graph evaluates.

#include "engine/small_motions/steady/derivatives.h"

#include <algorithm>
#include <cmath>

#include "engine/small_motions/steady/differences.h"

namespace spoke::steady {
namespace {

constexpr double kRoughStep = 1e-5;  ///< by the scale of a coordinate

/// Returns the forces on the subsystem, then those on the hub.
Eigen::VectorXd answer(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub,
                       SteadyModel& model) {
  SubsystemResponse response;
  model.evaluate(subsystem, state, hub, response);
  Eigen::VectorXd both(response.force.size() + response.hub_force.size());
  both << response.force, response.hub_force;
  return both;
}

/// Adds the derivatives by the hub's turn and twist.
void differ_by_hub(std::size_t subsystem, const SubsystemState& state, SteadyModel& model,
                   SubsystemDerivatives& by) {
  const Eigen::Index d = model.twist_size(), rows = state.q.size() + d;
  const HubOffset none = model.no_offset();
  const double speed = std::max(1.0, std::abs(model.speed()));
  by.by_turn = by.by_twist = Eigen::MatrixXd::Zero(rows, d);
  for (Eigen::Index c = 0; c < d; ++c) {
    const auto along = [&, c](HubVector HubOffset::*member) {
      return [&, c, member](double distance) {
        HubOffset offset = none;
        (offset.*member)[c] = distance;
        return answer(subsystem, state, offset, model);
      };
    };
    // The place of the hub has no effect.
    if (c >= model.first_rotation())
      by.by_turn.col(c) = differ_finely(kStep, along(&HubOffset::turn));
    by.by_twist.col(c) = differ(kVelocityStep * speed, along(&HubOffset::twist));
  }
}

}  // namespace

Eigen::MatrixXd calc_rough_derivative(std::size_t subsystem, const SubsystemState& state,
                                      SteadyModel& model) {
  const std::vector<SubsystemCoordinate>& coordinates = model.coordinates(subsystem);
  const Eigen::Index n = std::ssize(coordinates);
  const HubOffset none = model.no_offset();
  Eigen::MatrixXd by_q(n, n);
  SubsystemState moved = state;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double h = kRoughStep * coordinates[static_cast<std::size_t>(k)].scale;
    by_q.col(k) = differ(h, [&](double distance) {
                    moved.q[k] = state.q[k] + distance;
                    return answer(subsystem, moved, none, model);
                  }).head(n);
    moved.q[k] = state.q[k];
  }
  answer(subsystem, state, none, model);
  return by_q;
}

Eigen::MatrixXd calc_spring_stiffness(const std::vector<ClosureRow>& rows,
                                      const Eigen::MatrixXd& closures) {
  Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(closures.rows());
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (!rows[r].is_dropped) stiffness[static_cast<Eigen::Index>(r)] = rows[r].stiffness;
  Eigen::MatrixXd K = closures.transpose() * stiffness.asDiagonal() * closures;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].other == 0) continue;
    const auto at = static_cast<Eigen::Index>(r);
    K +=
        closures.row(at).transpose() * (rows[r].cross_stiffness * closures.row(at + rows[r].other));
  }
  return K;
}

Eigen::MatrixXd calc_stiffness(std::size_t subsystem, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& multipliers, SteadyModel& model) {
  const Eigen::Index n = q.size();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  const SubsystemState held{q, zero, q, zero, multipliers, true};
  const Eigen::MatrixXd by_q = calc_rough_derivative(subsystem, held, model);
  Eigen::MatrixXd K = model.stiffness(subsystem) - by_q.topRows(n);
  const std::vector<ClosureRow>& rows = model.closure_rows(subsystem);
  if (!rows.empty()) K += calc_spring_stiffness(rows, model.closures(subsystem).rightCols(n));
  return K;
}

SubsystemDerivatives calc_derivatives(std::size_t subsystem, const SubsystemState& state,
                                      bool with_hub, SteadyModel& model) {
  const std::vector<SubsystemCoordinate>& coordinates = model.coordinates(subsystem);
  const Eigen::Index n = std::ssize(coordinates), rows = n + model.twist_size();
  const HubOffset none = model.no_offset();
  const HeldStates held(subsystem, state, model);
  SubsystemDerivatives by{Eigen::MatrixXd(rows, n), Eigen::MatrixXd(rows, n), {}, {}};
  SubsystemState moved = state;
  for (Eigen::Index k = 0; k < n; ++k) {
    const SubsystemCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    by.by_q.col(k) = differ_finely(kStep * coordinate.scale, [&](double distance) {
      moved.q[k] = state.q[k] + distance;
      return answer(subsystem, moved, none, model);
    });
    moved.q[k] = state.q[k];
    by.by_v.col(k) =
        differ(kVelocityStep * velocity_scale(coordinate, model.speed()), [&](double rate) {
          moved.v[k] = state.v[k] + rate;
          return answer(subsystem, moved, none, model);
        });
    moved.v[k] = state.v[k];
  }
  if (with_hub) differ_by_hub(subsystem, state, model, by);
  answer(subsystem, state, none, model);
  return by;
}

Eigen::MatrixXd calc_by_forces(std::size_t subsystem, const SubsystemState& state,
                               const std::vector<ForceState>& forces, SteadyModel& model) {
  const HubOffset none = model.no_offset();
  return differ_by_forces(subsystem, state, forces, model,
                          [&] { return answer(subsystem, state, none, model); });
}

}  // namespace spoke::steady
