#pragma once

// Writes solids as JSON, in the shape of their tables.

#include "models/solid_body.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Adds the keys of a solid; names of files are absolute.
void add_solid(const SolidBody& body, Json& json);

/// Returns the name of a set, or a table.
Json choice_to_json(const NodeChoice& choice);

}  // namespace spoke::spatial
