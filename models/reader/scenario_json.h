#pragma once

// A scenario as JSON, in the shape of its file, with all values in force.

#include "models/scenario.h"
#include "models/support/json.h"

namespace spoke {

/// The whole scenario.
Json scenario_to_json(const Scenario& scenario);
/// The tables of what is simulated: hub, blades or subsystems, gravity, damping and loads.
Json model_to_json(const Scenario& scenario);
/// The table [integration].
Json integration_to_json(const Integration& integration);

}  // namespace spoke
