#pragma once

// Hints at air that is valid but cannot be right.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns a sentence for each aerofoil whose drag dips below zero: "aerofoil "du40": drag is
/// -0.0035 at 175 degrees, expected 0 or more".
std::vector<std::string> find_air_hints(const Scenario& scenario);

}  // namespace spoke
