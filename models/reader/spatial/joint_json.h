#pragma once

// A joint as JSON, in the shape of its table.

#include <nlohmann/json.hpp>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// [x, y, z].
nlohmann::ordered_json to_json(const Vector& v);

/// Adds the keys of a joint.
void add_joint(const Joint& joint, nlohmann::ordered_json& json);

}  // namespace spoke::spatial
