#pragma once

// Output of `spoke check` for a model in space.

#include "models/spatial_model.h"

namespace spoke::cli {

/// Prints the trees of bodies and joints, and the mass properties of each and of all.
void print_space(const spatial::Model& model);

}  // namespace spoke::cli
