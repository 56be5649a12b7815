#pragma once

// Hints at tension that beams with linear strains and solids do not know.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns a sentence for each beam that is given linear strains where these miss tension, and for
/// each solid that a joint moves or a loop pulls at.
std::vector<std::string> find_tension_hints(const Scenario& scenario);

}  // namespace spoke
