#pragma once

// What follows from the mesh of a solid, made once for a description.

#include <cstdint>
#include <memory>

#include "models/solid/made_constants.h"
#include "models/solid/solid.h"
#include "models/solid_body.h"
#include "spoke/error.h"

namespace spoke::solid {

/// A description with its mesh and its material read, the geometry that it has, and the constants
/// that were made of it.
struct KeptGeometry {
  spatial::SolidBody of{};
  SolidGeometry geometry{};
  std::uint64_t content = 0;  ///< hash_content()
  std::shared_ptr<ConstantsShelf> shelf = std::make_shared<ConstantsShelf>();
};

/// Whether an error of make_geometry() or make_constants() is one of a file of the solid: of a
/// mesh, of matrices, of their nodes. Its text begins with that place, "file:line: ", and wants no
/// key of the scenario in front. Else its place().key is within the body, and its text only says
/// what is wrong with that.
bool is_of_mesh(const InputError& error);

/// Returns the geometry that the description keeps, if it still belongs to it; else reads its mesh,
/// unless it has one, and makes the geometry. Of a description that has changed in other things
/// than its shape, it keeps only the geometry. Throws InputError as make_geometry() does.
std::shared_ptr<const KeptGeometry> find_geometry(const spatial::SolidBody& body);

/// Gives a description its mesh and its material, if they are in a file, and its geometry.
void keep_geometry(spatial::SolidBody& body);

/// Finds or makes the constants of a description. `key`: of the body, for errors. Throws InputError
/// as make_constants() does, its place().key and its text with that key; of matrices
/// "stiffness" stands for "mesh".
MadeConstants find_constants(const KeptGeometry& kept, const LoadedSets& sets,
                             const std::string& key, const Control& control, bool anew = false);

}  // namespace spoke::solid
