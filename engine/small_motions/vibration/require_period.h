#pragma once

// Several rotors that are not alike in all directions.

#include <string>

#include "engine/small_motions/vibration/mode_parts.h"

namespace spoke::vibration {

/// Throws InputError if a model has several rotors: Floquet's theory is built for one. Says whether
/// those that are not alike in all directions have a common period. `before`: what the message
/// begins with.
void require_period(const Linearised& all, const std::string& before);

}  // namespace spoke::vibration
