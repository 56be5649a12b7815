#pragma once

// Reads solids and the nodes that are chosen on them.

#include <string>
#include <string_view>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the keys of a table that describes a solid.
TomlSection::Keys solid_keys();

/// Reads a solid with its mesh, its material if that is in the mesh's file, and its geometry
/// (SolidBody::kept). Files are relative to `folder`. A body of `before`, subsystems that are read,
/// or of `own`, the bodies read so far of the same subsystem, lends its mesh if that is of the same
/// file, and its geometry if it has the same shape. Throws InputError with file, line and key of
/// the section; of what is wrong in a mesh or in matrices, with their file and line.
SolidBody read_solid(const TomlSection& section, const std::string& folder,
                     const std::vector<Subsystem>& before, const Subsystem& own);

/// Reads a choice of nodes: the name of a set, or a table that says where they are.
NodeChoice read_choice(const TomlSection& section, std::string_view key);

}  // namespace spoke::spatial
