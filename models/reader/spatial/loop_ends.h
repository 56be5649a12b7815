#pragma once

// Rules for loops that end on another blade or subsystem, which are looked at when all are known.

#include <string>

#include "models/reader/spatial/fault.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// LoopPlace::blade while "next" of a file is not yet a number: the next blade of the rotor, behind
/// the last one the first.
inline constexpr int kNextBlade = -1;
/// Puts the numbers in the place of kNextBlade, in loops and couplings.
void resolve_next_blades(Model& model);

/// Finds a blade or a subsystem, one of the two, that is not there.
Fault find_tree_fault(int blade, const std::string& subsystem, const Model& model);

/// Finds the first fault of such an end, "blades.2.loop.1.to.blade".
Fault find_loop_end_fault(const Model& model);

}  // namespace spoke::spatial
