#pragma once

// Rules for solids, and for what acts on them.

#include <string>

#include "models/reader/spatial/fault.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// The words of messages for what chooses nodes.
inline constexpr const char* kNodesExpected =
    "the name of a set of the mesh, { plane = { ... } }, { cylinder = { ... } } or { box = { ... } "
    "}";

/// Finds a fault of a choice of nodes, whatever the mesh.
Fault find_choice_fault(const NodeChoice& choice);

/// Finds an interface that a solid does not have: "interface".
Fault find_interface_fault(const std::string& name, const SolidBody& body);

/// Finds a fault of what a load on a solid says of its place, and of its traction.
Fault find_load_fault(const PointLoad& load, const SolidBody& body);

/// Finds a fault that shows without the mesh.
Fault find_description_fault(const SolidBody& body);

}  // namespace spoke::spatial
