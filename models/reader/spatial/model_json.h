#pragma once

// A model in space as JSON, in the shape of its file.

#include <nlohmann/json.hpp>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Adds the tables of the model, defaults included, to those of its scenario.
void add_model(const Model& model, nlohmann::ordered_json& json);

}  // namespace spoke::spatial
