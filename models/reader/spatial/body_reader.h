#pragma once

// Reads blades and subsystems.

#include <vector>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads [blade] and [[blades]] from a scenario's root; none if there are none.
std::vector<Blade> read_blades(const TomlSection& root);

/// Reads [[subsystem]] from a scenario's root.
std::vector<Subsystem> read_subsystems(const TomlSection& root);

}  // namespace spoke::spatial
