#pragma once

// Reads meshes of Abaqus and CalculiX.

#include <optional>
#include <string>
#include <string_view>

#include "models/solid/mesh_parts.h"

namespace spoke::solid {

/// Reads the text of an .inp file. Node sets, element sets and surfaces become sets. Sets
/// `material` if the file has one that is isotropic, unless it is null. Throws InputError.
MeshParts read_inp(std::string_view text, const std::string& file,
                   std::optional<spatial::SolidMaterial>* material);

/// Reads nodes and sets, of elements of any types, and no elements. Throws InputError.
MeshParts read_inp_nodes(std::string_view text, const std::string& file);

}  // namespace spoke::solid
