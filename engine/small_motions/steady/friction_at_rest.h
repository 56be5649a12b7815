#pragma once

// Friction of joints in small motions about rest.

#include "models/scenario.h"

namespace spoke::steady {

/// Whether a joint of a model in space has friction.
bool has_friction(const Scenario& scenario);

/// Returns the scenario with a damper in place of each friction: its slope at rest.
Scenario with_friction_at_rest(const Scenario& scenario);

}  // namespace spoke::steady
