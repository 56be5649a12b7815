#pragma once

// Modes seen from outside, in multi-blade coordinates.

#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// Takes a rotor, or all of a support, to multi-blade coordinates, and puts them on their support,
/// if they have one. Throws like make_fixed_frame().
FixedFrame see_from_outside(const Linearised& all);

/// Takes one of the rotors on a support there, without the support. Throws like
/// make_fixed_frame().
FixedFrame see_rotor_from_outside(std::size_t rotor, const Linearised& all);

/// Whether a rotor on a support is alike in all directions, so that see_from_outside() takes it.
bool is_even(std::size_t rotor, const Linearised& all);

/// Adds the lowest modes of one or more rotors in the frame that stands: `count` of the whole
/// model. Throws like make_fixed_frame().
void add_fixed_modes(const ModeCount& count, const Linearised& all, ModesResult& result);

}  // namespace spoke::vibration
