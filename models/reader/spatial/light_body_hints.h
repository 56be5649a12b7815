#pragma once

// Hints at rigid bodies whose inertia is so small that a formulation loses digits.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns a sentence for each rigid body behind a joint that turns, in a subsystem that has
/// flexible bodies, too, whose inertia about its centre of mass is next to nothing beside mass
/// times the square of the centre's distance from the joint: `structured` then loses the square of
/// that ratio (docs/formulation.md, section 4.1). Subsystems of rigid bodies alone lose nothing.
std::vector<std::string> find_light_body_hints(const Scenario& scenario);

}  // namespace spoke
