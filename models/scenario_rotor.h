#pragma once

#include "models/rotor.h"
#include "models/toml_section.h"

namespace spoke {

/// Reads hub, blades, gravity, damping and loads from a scenario's root. Throws InputError.
Rotor read_rotor(const TomlSection& root);

}  // namespace spoke
