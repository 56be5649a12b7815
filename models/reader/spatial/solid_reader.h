#pragma once

// Reads solids and the nodes that are chosen on them.

#include <string>
#include <string_view>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the keys of a table that describes a solid.
TomlSection::Keys solid_keys();

/// Reads a solid with its mesh. Files are relative to `folder`; a body of `before` that has the
/// same mesh lends it. Throws InputError, also about what the mesh shows.
SolidBody read_solid(const TomlSection& section, const std::string& folder,
                     const std::vector<Subsystem>& before, const Subsystem& own);

/// Reads a choice of nodes: the name of a set, or a table that says where they are.
NodeChoice read_choice(const TomlSection& section, std::string_view key);

}  // namespace spoke::spatial
