#pragma once

// Reads joints.

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads a joint. Throws InputError, also about what find_fault() finds.
Joint read_joint(const TomlSection& section);

}  // namespace spoke::spatial
