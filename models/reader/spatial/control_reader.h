#pragma once

// Reads [control].

#include <optional>
#include <string>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads the controller of a model, whose joints are read, if there is one. Paths of files are from
/// `folder`.
void read_control(const TomlSection& root, const std::string& folder, Model& model);

}  // namespace spoke::spatial
