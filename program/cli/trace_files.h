#pragma once

// What `spoke trace` and `spoke run --trace` do with a trace.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/simulation.h"

namespace spoke::cli {

/// As --buffer takes them, rounded up.
std::int64_t megabytes(std::size_t bytes);

/// Writes the files of a trace that `simulation` has made to a folder that is there, and, if
/// `prints`, says what they show and where they are. Throws InputError. Precondition: there is a
/// step.
void write_trace(const Simulation& simulation, StepTrace steps, const std::filesystem::path& folder,
                 bool prints);

/// The same of what a run has recorded, none if it had no step left. Without a step a line on
/// stderr says why there is no trace.
void write_trace_of_run(const Simulation& simulation, std::optional<StepTrace> steps,
                        const std::filesystem::path& folder, bool prints);

}  // namespace spoke::cli
