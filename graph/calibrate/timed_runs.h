#pragma once

// What the calibrations of this folder time with.

#include <cstdint>

#include "graph/executor.h"

namespace spoke::graph {

/// Since time_stamp() gave `begin` [s].
double seconds_since(std::uint64_t begin);

/// Keeps the calling thread busy for so long [s].
void be_busy(double seconds) noexcept;

/// Of `runs` runs, behind one that warms up, the lower quartile [s].
double seconds_per_run(Executor& executor, int runs);

}  // namespace spoke::graph
