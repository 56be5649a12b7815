#pragma once

// The start of a simulation from an equilibrium.

#include <Eigen/Core>
#include <vector>

#include "models/scenario.h"

namespace spoke::steady {

/// Returns the coordinates of the bodies in equilibrium at start_speed(), under the loads at t = 0,
/// as put_bodies() takes them. `scenario` comes from skip_start_up(). Throws InputError if nothing
/// holds a joint, or if forces on a free hub are not in balance; DivergenceError if no equilibrium
/// is found.
std::vector<Eigen::VectorXd> find_start(const Scenario& scenario);

}  // namespace spoke::steady
