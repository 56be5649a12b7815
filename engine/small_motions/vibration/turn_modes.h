#pragma once

// Modes of a small system with periodic matrices, from its states over one turn.

#include <vector>

#include "engine/small_motions/vibration/periodic_mode.h"
#include "engine/small_motions/vibration/periodic_system.h"

namespace spoke::vibration {

/// Returns the modes that find_periodic_modes() describes, from the states over a turn that begin
/// as all unit states: full matrices are factorised at each step. Throws InputError if the modes
/// are too fast for 8192 steps over a turn.
std::vector<PeriodicMode> find_modes_over_turn(const PeriodicSystem& system, Eigen::Index count);

/// Returns the magnitude that the `count` least roots of the mean system reach, by the speed: how
/// many times in a turn they go round.
double find_reach(const PeriodicSystem& system, Eigen::Index count);

}  // namespace spoke::vibration
