#pragma once

// What the outputs of a tree show, and its derivatives at a state.

#include "engine/steady/steady_model.h"

namespace spoke::steady {

/// SteadyModel::measure() at a state.
Eigen::VectorXd measure(std::size_t tree, const TreeState& state, const HubOffset& hub,
                        SteadyModel& model);

/// Its derivatives, elastic forces moving along; of the hub by what HubOffset has.
struct OutputDerivatives {
  Eigen::MatrixXd by_q, by_v, by_turn, by_twist, by_acceleration;
};
OutputDerivatives calc_output_derivatives(std::size_t tree, const TreeState& state,
                                          SteadyModel& model);

}  // namespace spoke::steady
