#pragma once

// Reads the key "blade" of loads and sensors.

#include <cstddef>

#include "models/blade_choice.h"
#include "models/reader/toml_section.h"

namespace spoke {

/// Reads `blade` of a table: a number from 1 to `blades`, or "all", the value if the key is
/// missing.
BladeChoice read_blade(const TomlSection& section, std::size_t blades);

}  // namespace spoke
