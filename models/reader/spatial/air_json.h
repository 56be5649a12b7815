#pragma once

// Writes the air of a model, and the aerodynamics of its blades, as the reader reads them.

#include "models/spatial_model.h"
#include "models/support/json.h"

namespace spoke::spatial {

Json aerodynamics_to_json(const BladeAerodynamics& aerodynamics);

/// Adds "air", "wind", "aerodynamics" and "airfoil" to a scenario.
void add_air(const Air& air, Json& json);

}  // namespace spoke::spatial
