#pragma once

// Reads [control.pitch].

#include <optional>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads the pitch controller of a model, whose joints are read; none if there is none.
std::optional<PitchControl> read_pitch_control(const TomlSection& root, const Model& model);

}  // namespace spoke::spatial
