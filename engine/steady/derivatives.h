#pragma once

// Derivatives of the forces on a tree and the hub at a state, elastic forces held: these are
// linear, and their constant matrices known exactly. What is left is smooth on the scale of the
// coordinates, so that differences lose no digits to the stiffest vibrations.

#include "engine/steady/steady_model.h"

namespace spoke::steady {

/// dF/dq with elastic forces held, by second-order differences: for Newton's method. Leaves the
/// state evaluated.
Eigen::MatrixXd calc_rough_derivative(std::size_t tree, const TreeState& state, SteadyModel& model);

/// Derivatives of the forces on the tree's n coordinates and, below, on the hub, by coordinates,
/// velocities, the hub's turn and the hub's twist.
struct TreeDerivatives {
  Eigen::MatrixXd by_q, by_v, by_turn, by_twist;
};

/// By central differences: of fourth order in what turns and moves (Richardson's extrapolation of
/// two steps), of second order in velocities, in which forces are quadratic and these differences
/// exact; steps by the scale of each coordinate. `with_hub`: by the hub's motion, too; else those
/// are empty. Leaves the state evaluated.
TreeDerivatives calc_derivatives(std::size_t tree, const TreeState& state, bool with_hub,
                                 SteadyModel& model);

}  // namespace spoke::steady
