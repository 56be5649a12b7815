#pragma once

// Clocks and timed runs for the calibrations of this folder.

#include <cstdint>

#include "graph/executor.h"

namespace spoke::graph {

/// Returns the time since time_stamp() gave `begin` [s].
double seconds_since(std::uint64_t begin);

/// Keeps the calling thread busy for `seconds`.
void be_busy(double seconds) noexcept;

/// Returns the lower quartile of the times of `runs` runs, after one that warms up [s].
double seconds_per_run(Executor& executor, int runs);

}  // namespace spoke::graph
