#pragma once

// Modes of models whose matrices, seen from outside, are periodic.

#include "engine/small_motions/vibration/mode_parts.h"

namespace spoke::vibration {

/// Adds the lowest modes of any rotor by Floquet's theory: `count` of the whole model. `whole`: the
/// model made with SteadyOptions::is_whole; null: what turns against the hub does not count. Throws
/// like find_periodic_modes() and find_periodic_orbit(), and InputError if there are too few modes.
void add_floquet_modes(const ModeCount& count, const Linearised& all, steady::SteadyModel* whole,
                       ModesResult& result);

}  // namespace spoke::vibration
