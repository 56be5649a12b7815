#pragma once

// Hints at solids that are valid but too stiff.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns a sentence for each mesh with linear elements, which lock: "the mesh of bracket / arm
/// has linear elements (tet4), which ...".
std::vector<std::string> find_solid_hints(const Scenario& scenario);

}  // namespace spoke
