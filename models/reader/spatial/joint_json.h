#pragma once

// Writes a joint as JSON, in the shape of its table.

#include "models/spatial_model.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Returns [x, y, z].
Json to_json(const Vector& v);

/// Adds the keys of a joint.
void add_joint(const Joint& joint, Json& json);

}  // namespace spoke::spatial
