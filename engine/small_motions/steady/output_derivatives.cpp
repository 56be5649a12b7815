// Takes differences of the values that sensors show.

#include "engine/small_motions/steady/output_derivatives.h"

#include "engine/small_motions/steady/differences.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns derivatives by a member of the hub's offset, of which `scale` is a large value.
template <class Differ>
MatrixXd differ_by_hub(HubVector HubOffset::*member, std::size_t subsystem,
                       const SubsystemState& state, SteadyModel& model, const Differ& differ) {
  const Eigen::Index d = model.twist_size();
  MatrixXd by_hub(std::ssize(model.outputs(subsystem)), d);
  for (Eigen::Index c = 0; c < d; ++c)
    by_hub.col(c) = differ([&](double distance) {
      HubOffset offset = model.no_offset();
      (offset.*member)[c] = distance;
      return measure(subsystem, state, offset, model);
    });
  return by_hub;
}

}  // namespace

VectorXd measure(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub,
                 SteadyModel& model) {
  SubsystemResponse response;
  model.evaluate(subsystem, state, hub, response);
  model.accelerations(subsystem);
  return model.measure(subsystem);
}

OutputDerivatives calc_output_derivatives(std::size_t subsystem, const SubsystemState& state,
                                          SteadyModel& model) {
  const std::vector<SubsystemCoordinate>& coordinates = model.coordinates(subsystem);
  const Eigen::Index n = std::ssize(coordinates), rows = std::ssize(model.outputs(subsystem));
  const HubOffset none = model.no_offset();
  const double rate = kVelocityStep * velocity_scale({}, model.speed());
  const HeldStates held(subsystem, state, model);
  OutputDerivatives by{MatrixXd(rows, n), MatrixXd(rows, n), {}, {}, {}, {}};
  SubsystemState moved = state;
  for (Eigen::Index k = 0; k < n; ++k) {
    const SubsystemCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    by.by_q.col(k) = differ_finely(kStep * coordinate.scale, [&](double distance) {
      moved.q[k] = moved.q_elastic[k] = state.q[k] + distance;
      return measure(subsystem, moved, none, model);
    });
    moved.q[k] = moved.q_elastic[k] = state.q[k];
    by.by_v.col(k) = differ(rate * coordinate.scale, [&](double velocity) {
      moved.v[k] = moved.v_elastic[k] = state.v[k] + velocity;
      return measure(subsystem, moved, none, model);
    });
    moved.v[k] = moved.v_elastic[k] = state.v[k];
  }
  const auto of_turn = [](const auto& at) { return differ_finely(kStep, at); };
  const auto of_rate = [rate](const auto& at) { return differ(rate, at); };
  by.by_turn = differ_by_hub(&HubOffset::turn, subsystem, state, model, of_turn);
  by.by_twist = differ_by_hub(&HubOffset::twist, subsystem, state, model, of_rate);
  by.by_acceleration = differ_by_hub(&HubOffset::acceleration, subsystem, state, model, of_rate);
  by.by_forces = MatrixXd::Zero(rows, 0);
  if (const std::vector<ForceState> forces = model.force_states(subsystem); !forces.empty())
    by.by_forces = differ_by_forces(subsystem, state, forces, model,
                                    [&] { return measure(subsystem, state, none, model); });
  measure(subsystem, state, none, model);
  return by;
}

MatrixXd by_independent(const MatrixXd& by_q, const MatrixXd& by_forces,
                        const LinearSubsystem& own) {
  MatrixXd by = own.basis.rows() > 0 ? MatrixXd(by_q * own.basis) : by_q;
  if (by_forces.size() > 0) by(Eigen::all, own.forces) = by_forces;
  return by;
}

}  // namespace spoke::steady
