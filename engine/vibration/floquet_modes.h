#pragma once

// Modes of models whose matrices, seen from outside, are periodic.

#include "engine/vibration/mode_parts.h"

namespace spoke::vibration {

/// Adds the lowest modes of any rotor by Floquet's theory: `count` of the whole model. Throws like
/// find_periodic_modes(), and InputError if there are too few modes.
void add_floquet_modes(const ModeCount& count, const Linearised& all, ModesResult& result);

}  // namespace spoke::vibration
