#pragma once

// Central differences.

#include <Eigen/Core>
#include <vector>

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

// Steps of the differences, by the scale of a coordinate. The error of fourth order is h^4/30 of
// the fifth derivative, 1e-14 at this step; round-off is 1e-16/h of the size of the forces.
constexpr double kStep = 1e-3;
constexpr double kVelocityStep = 1e-3;

/// Returns the derivative of `at`, a function of a distance that yields a vector, to second order.
template <class At>
Eigen::VectorXd differ(double h, const At& at) {
  return (at(h) - at(-h)) / (2.0 * h);
}

/// Returns the same derivative to fourth order.
template <class At>
Eigen::VectorXd differ_finely(double h, const At& at) {
  return (4.0 * differ(h, at) - differ(2.0 * h, at)) / 3.0;
}

/// Returns the derivatives of answer(), which evaluates the model at `state`, by z of `forces`, in
/// columns. It is linear in them. Held states stay held, as they are there.
template <class Answer>
Eigen::MatrixXd differ_by_forces(std::size_t subsystem, const SubsystemState& state,
                                 const std::vector<ForceState>& forces, SteadyModel& model,
                                 const Answer& answer) {
  const HeldStates held(subsystem, state, model);
  std::vector<double> states = model.advance_states(subsystem, 0.0);
  const Eigen::VectorXd before = answer();
  Eigen::MatrixXd by(before.size(), std::ssize(forces));
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const double scale =
        model.coordinates(subsystem)[static_cast<std::size_t>(forces[k].coordinate)].scale;
    const double kept = states[forces[k].state], z = forces[k].stiffness * scale;
    states[forces[k].state] = kept - z;
    model.hold_states_at(subsystem, states);
    by.col(static_cast<Eigen::Index>(k)) = (answer() - before) / z;
    states[forces[k].state] = kept;
  }
  model.hold_states_at(subsystem, states);
  return by;
}

}  // namespace spoke::steady
