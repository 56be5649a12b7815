#pragma once

// Where the loads of a rotor act on its bodies.

#include "models/system/system.h"

namespace spoke {

/// Puts the loads and drags of a rotor on the bodies of its blades. What is per length acts at the
/// points of Gauss's rule of four in each element, or part of one: by the shape functions that is
/// the exact integral of a constant load, and of linear drag.
void place_loads(const Rotor& rotor, System& system);

}  // namespace spoke
