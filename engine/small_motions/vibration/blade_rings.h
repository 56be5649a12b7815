#pragma once

// Blades that loops between them tie, as dampers from one to the next do, in a linear model in
// which they are one subsystem.

#include <vector>

#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// Returns by subsystem the blades of which it consists. A ring is even if its blades, three or
/// more, stand at equal angles, have the same independent coordinates, which move them alone, and
/// if all matrices stay as they are when each blade takes the place of the next one.
std::vector<BladeRing> find_rings(const Linearised& all);

}  // namespace spoke::vibration
