#pragma once

// Reads [air], [aerodynamics] and [[airfoil]], and the aerodynamics of a blade.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads one number for each station, or one for all; leaves out what is not there.
void read_stations(const TomlSection& section, std::string_view key, const Quantity& quantity,
                   std::size_t stations, std::vector<double>& values);

/// Returns the keys of [blade.aerodynamics].
TomlSection::Keys aerodynamics_keys();
/// Reads [blade.aerodynamics] of a blade whose beam has this length [m].
BladeAerodynamics read_aerodynamics(const TomlSection& section, double length);

/// Reads the air around a model whose blades are read; none if there is no [air]. An aerofoil that
/// no [[airfoil]] names is a file, relative to `folder`.
std::optional<Air> read_air(const TomlSection& root, const std::string& folder, const Model& model);

}  // namespace spoke::spatial
