#pragma once

// Hints at sections of beams that are valid, but may not be what is meant.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns a sentence for each kind of inertia of sections that is left to its default and makes a
/// radius of gyration of half a beam's length or more: the stiffnesses behind it are not those of a
/// section, "the default lag_inertia of blade 1 ...".
std::vector<std::string> find_section_hints(const Scenario& scenario);

}  // namespace spoke
