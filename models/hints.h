#pragma once

// Hints at what is valid in a scenario, but looks as if something else were meant.

#include <string>
#include <vector>

#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// Returns a sentence for each: angles that seem to be degrees, drag below zero, what a solid's
/// mesh leaves out of its file, materials in other units, default inertias far out of a section,
/// bodies of next to no inertia beside flexible ones, tension that linear strains do not know.
/// `spoke check`, `run` and the other commands print them as warnings.
SPOKE_EXPORT std::vector<std::string> find_hints(const Scenario& scenario);

}  // namespace spoke
