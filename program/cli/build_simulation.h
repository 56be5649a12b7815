#pragma once

// Builds simulations for all commands.

#include <string>

#include "engine/simulation.h"

namespace spoke::cli {

/// Builds the simulation of a scenario that was read from `file`; shows on the terminal how far its
/// solids are made, if `shows_progress`. Throws InputError, its text
/// beginning with the file.
Simulation build_simulation(const std::string& file, const Scenario& scenario,
                            const SimulationOptions& options, bool shows_progress = true);

}  // namespace spoke::cli
