#pragma once

// Output about closed loops.

#include "engine/simulation.h"

namespace spoke::cli {

/// Prints the loops of each blade or subsystem, its freedoms, and redundant rows. Nothing without
/// loops.
void print_loops(const Simulation& simulation);

/// Prints which joints were moved so that loops are closed, and how far.
void print_moved_joints(const Simulation& simulation);

}  // namespace spoke::cli
