#pragma once

#include <filesystem>

#include "engine/simulation.h"

namespace spoke::cli {

/// Writes the files of a trace that `simulation` has made, in a folder that is made if needed, and,
/// if `prints`, says what they show and where they are. Without a complete step nothing is written,
/// and it says so. Throws InputError.
void write_trace(const Simulation& simulation, StepTrace steps, const std::filesystem::path& folder,
                 bool prints);

}  // namespace spoke::cli
