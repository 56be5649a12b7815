#pragma once

// The state-space matrices of rotors that are seen from outside, in multi-blade coordinates.

#include "engine/linearize.h"
#include "engine/small_motions/vibration/mode_parts.h"

namespace spoke::vibration {

/// Makes the matrices of a rotor, or of all on a support, about its equilibrium. The model
/// has outputs, and is left at the equilibrium; LinearSystem::equilibrium is left empty. Throws
/// like make_fixed_frame(), and InputError if too many coordinates couple.
LinearSystem make_multi_blade_system(const Scenario& scenario, const Linearised& all);

}  // namespace spoke::vibration
