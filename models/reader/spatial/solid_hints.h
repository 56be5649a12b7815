#pragma once

// Hints at solids that are valid, but may not be what is meant.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke {

/// Returns sentences: for each mesh with linear elements, which lock, "the mesh of bracket / arm
/// has linear elements (tet4), which ..."; for each whose file says what the solid has not, or has
/// another material.
std::vector<std::string> find_solid_hints(const Scenario& scenario);

}  // namespace spoke
