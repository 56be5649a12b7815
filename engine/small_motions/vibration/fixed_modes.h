#pragma once

// Modes seen from outside, in multi-blade coordinates.

#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// Takes a rotor to multi-blade coordinates, and puts it on its support, if it has one. Throws like
/// make_fixed_frame().
FixedFrame see_from_outside(const Linearised& all);

/// Adds the lowest modes of a rotor in the frame that stands: `count` of the whole model. Throws
/// like make_fixed_frame().
void add_fixed_modes(const ModeCount& count, const Linearised& all, ModesResult& result);

}  // namespace spoke::vibration
