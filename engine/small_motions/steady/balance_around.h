#pragma once

// Equilibria of what springs hold against which the hub turns.

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Throws InputError, which names the loop, unless a subsystem that is in equilibrium at azimuth
/// zero of the hub is so at every other.
void require_balance_around(std::size_t subsystem, const SubsystemState& state, SteadyModel& model);

}  // namespace spoke::steady
