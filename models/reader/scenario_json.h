#pragma once

// Writes a scenario as JSON, in the shape of its file, with all values in force.

#include "models/scenario.h"
#include "models/support/json.h"

namespace spoke {

/// Returns the whole scenario.
Json scenario_to_json(const Scenario& scenario);
/// Returns the tables of the model: hub, blades or subsystems, gravity, damping and loads.
Json model_to_json(const Scenario& scenario);
/// Returns the table [integration].
Json integration_to_json(const Scenario& scenario);

}  // namespace spoke
