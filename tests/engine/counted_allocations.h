#pragma once

// Counts of all allocations of the process, by a malloc of its own (counted_allocations.cpp).

#include <atomic>
#include <cstddef>

#include "engine/simulation.h"

namespace spoke::test {

extern std::atomic<long> allocations;
extern std::atomic<std::size_t> allocated_bytes;
/// Allocations by operator new of C++. Runtimes of OpenMP allocate their tasks by malloc, some more
/// or fewer from pass to pass.
extern std::atomic<long> allocations_by_new;

/// Returns the allocations of so many steps, behind three in which runtimes fill their pools.
long allocations_of_steps(const Scenario& scenario, const SimulationOptions& options, int steps);

}  // namespace spoke::test
