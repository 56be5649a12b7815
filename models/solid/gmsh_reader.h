#pragma once

// Reads meshes of gmsh.

#include <string>
#include <string_view>

#include "models/solid/mesh_parts.h"

namespace spoke::solid {

/// Reads the text of a .msh file, of format 2 or 4.1, ASCII or binary. Physical groups become sets,
/// by their names or else numbers. Throws InputError.
MeshParts read_gmsh(std::string_view text, const std::string& file);

}  // namespace spoke::solid
