#pragma once

// Hints at materials in other units.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns a sentence for the first body whose Young's modulus is not one of a solid of its
/// density: "the material of blade 1 has Young's modulus 210 Pa ...".
std::vector<std::string> find_material_hints(const Scenario& scenario);

}  // namespace spoke
