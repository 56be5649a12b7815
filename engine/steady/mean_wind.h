#pragma once

// The wind that a model in steady rotation knows: the same at every place and time.

#include "engine/steady/steady_model.h"
#include "models/scenario.h"

namespace spoke::steady {

/// Whether a scenario has air, and a wind that is not the same at every place and time.
bool has_changing_wind(const Scenario& scenario);

/// Returns the scenario in the mean of the wind at its undeformed hub, see WindField::mean(); of a
/// course over time in its value at `instant`. Precondition: has_changing_wind().
Scenario in_mean_wind(const Scenario& scenario, Instant instant);

}  // namespace spoke::steady
