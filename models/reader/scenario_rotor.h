#pragma once

// Reads the rotor of a scenario file.

#include "models/reader/toml_section.h"
#include "models/rotor.h"

namespace spoke {

/// Reads [hub.drive] from the table of the hub. Throws InputError.
Drive read_drive(const TomlSection& hub);

/// Reads hub, blades, gravity, damping and loads from a scenario's root. Throws InputError.
Rotor read_rotor(const TomlSection& root);

}  // namespace spoke
