#pragma once

// Several rotors at speeds of their own.

#include <string>
#include <vector>

#include "engine/small_motions/vibration/mode_parts.h"

namespace spoke::vibration {

/// Returns for each rotor on a support whether it is to be seen from outside, in multi-blade
/// coordinates, so that the model has one period: those that are alike in all directions are,
/// unless they are as fast as those that are not, in either sense; none if all are as fast. Empty:
/// there is no support. Throws InputError if Floquet's theory has no period or needs none.
/// `before`: what the message begins with.
std::vector<bool> require_period(const Linearised& all, const std::string& before);

}  // namespace spoke::vibration
