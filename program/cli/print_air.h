#pragma once

// Output of `spoke check` for a model in air.

#include "models/spatial_model.h"

namespace spoke::cli {

/// Prints air, wind, the stations of blades and their aerofoils. Precondition: the model has air.
void print_air(const spatial::Model& model);

}  // namespace spoke::cli
