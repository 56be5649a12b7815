#pragma once

// Closes the loops of a subsystem before its equilibrium is sought.

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Moves coordinates until the rigid rows of the loops are closed, joints alone if these can.
/// Returns the rows that are independent there. Throws InputError, naming the loop, if they cannot
/// be closed.
std::vector<Eigen::Index> close_loops(std::size_t subsystem, SteadyModel& model,
                                      Eigen::VectorXd& q);

}  // namespace spoke::steady
