#pragma once

// Files and summary of a trace, for `spoke trace` and `spoke run --trace`.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/simulation.h"
#include "program/trace/more_threads.h"

namespace spoke::cli {

/// Returns the size in units of --buffer, rounded up.
std::int64_t megabytes(std::size_t bytes);

/// Writes the files of a trace that `simulation` has made to an existing folder and, if `prints`, a
/// summary to standard output, with what more threads would gain where that is known. Throws
/// InputError. Precondition: there is a step.
void write_trace(const Simulation& simulation, StepTrace steps, const std::filesystem::path& folder,
                 bool prints, std::optional<trace::MoreThreads> more_threads = {});

/// Writes the trace that a run has recorded as write_trace() does; `steps` is none if the run had
/// no step left. Without a step a line on stderr says why there is no trace.
void write_trace_of_run(const Simulation& simulation, std::optional<StepTrace> steps,
                        const std::filesystem::path& folder, bool prints);

}  // namespace spoke::cli
