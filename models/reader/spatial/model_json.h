#pragma once

// Writes a model in space as JSON, in the shape of its file.

#include "models/spatial_model.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Adds the tables of the model, defaults included, to those of its scenario.
void add_model(const Model& model, Json& json);

}  // namespace spoke::spatial
