#pragma once

// Several rotors at speeds of their own.

#include <string>

#include "engine/small_motions/vibration/mode_parts.h"

namespace spoke::vibration {

/// Throws InputError if a model has several rotors that turn, but not equally fast in either sense:
/// Floquet's theory needs one period. Says whether those that are not alike in all directions have
/// one. `before`: what the message begins with.
void require_period(const Linearised& all, const std::string& before);

}  // namespace spoke::vibration
