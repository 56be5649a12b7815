#pragma once

// Outputs of a subsystem and their derivatives at a state.

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Returns SteadyModel::measure() at a state.
Eigen::VectorXd measure(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub,
                        SteadyModel& model);

/// Derivatives of measure(), with elastic forces following the coordinates; those by the hub are by
/// the members of HubOffset, those by forces by z of SteadyModel::force_states().
struct OutputDerivatives {
  Eigen::MatrixXd by_q, by_v, by_turn, by_twist, by_acceleration, by_forces;
};
OutputDerivatives calc_output_derivatives(std::size_t subsystem, const SubsystemState& state,
                                          SteadyModel& model);

/// Takes derivatives by all coordinates to those by independent ones, with those by forces among
/// them; `by_forces` may be empty.
Eigen::MatrixXd by_independent(const Eigen::MatrixXd& by_q, const Eigen::MatrixXd& by_forces,
                               const LinearSubsystem& own);

}  // namespace spoke::steady
