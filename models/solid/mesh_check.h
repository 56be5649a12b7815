#pragma once

// Finds what makes a mesh no body.

#include <string>

#include "models/solid_body.h"

namespace spoke::solid {

/// Throws InputError, place().key "mesh", with file and line if the mesh has them, if a mesh is not
/// one connected body of elements with positive volume, of a sensible size.
void check_mesh(const spatial::SolidMesh& mesh);

/// Tells whether some of its elements are linear, tet4 or hex8, which are too stiff in bending.
bool has_locking_elements(const spatial::SolidMesh& mesh);

/// Returns the name of a node for messages: "node 17", by its number in the file.
std::string name_of_node(const spatial::SolidMesh& mesh, int node);

}  // namespace spoke::solid
