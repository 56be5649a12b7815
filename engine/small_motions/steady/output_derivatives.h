#pragma once

// Outputs of a subsystem and their derivatives at a state.

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Returns SteadyModel::measure() at a state.
Eigen::VectorXd measure(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub,
                        SteadyModel& model);

/// Derivatives of measure(), with elastic forces following the coordinates; those by the hub are by
/// the members of HubOffset.
struct OutputDerivatives {
  Eigen::MatrixXd by_q, by_v, by_turn, by_twist, by_acceleration;
};
OutputDerivatives calc_output_derivatives(std::size_t subsystem, const SubsystemState& state,
                                          SteadyModel& model);

}  // namespace spoke::steady
