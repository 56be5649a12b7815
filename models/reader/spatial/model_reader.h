#pragma once

// Reads the model in space of a scenario file.

#include <string>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads hub, blades, subsystems, gravity, damping and loads from a scenario's root, and meshes of
/// solids, whose files are relative to `folder`. Throws InputError.
Model read_model(const TomlSection& root, const std::string& folder);

}  // namespace spoke::spatial
