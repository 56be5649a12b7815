#pragma once

// Reads blades and subsystems.

#include <vector>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads [blade] and [[blades]] from a scenario's root; none if there are none. The model has its
/// hub and its anchors, on which loops may close.
std::vector<Blade> read_blades(const TomlSection& root, const Model& model);

/// Reads [[subsystem]] from a scenario's root. The model has its hub and its anchors.
std::vector<Subsystem> read_subsystems(const TomlSection& root, const Model& model);

}  // namespace spoke::spatial
