#pragma once

// The rotor in a scenario file.

#include "models/reader/toml_section.h"
#include "models/rotor.h"

namespace spoke {

/// Reads hub, blades, gravity, damping and loads from a scenario's root. Throws InputError.
Rotor read_rotor(const TomlSection& root);

}  // namespace spoke
