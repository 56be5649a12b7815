#pragma once

// Where a simulation from an equilibrium starts.

#include <Eigen/Core>
#include <vector>

#include "models/scenario.h"

namespace spoke::steady {

/// Coordinates of the bodies in equilibrium at start_speed(), under what acts at t = 0, as
/// put_bodies() takes them. `scenario` comes from skip_start_up(). Throws InputError if nothing
/// holds a joint, or if forces on a free hub are not in balance; DivergenceError if none is found.
std::vector<Eigen::VectorXd> find_start(const Scenario& scenario);

}  // namespace spoke::steady
