#pragma once

// Reads the tables of a scenario that describe loads.

#include <string>

#include "models/reader/toml_section.h"
#include "models/rotor.h"

namespace spoke {

/// Reads the loads on a rotor that has its blades. Throws InputError about what is wrong in them.
void read_loads(const TomlSection& root, Rotor& rotor);

/// Reads the name of a load; empty if it has none. Throws InputError if it is none.
std::string read_load_name(const TomlSection& section);

}  // namespace spoke
