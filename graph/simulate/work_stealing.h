#pragma once

// Simulates a plan on the ready deques of oneTBB's threads.

#include <span>

#include "graph/simulate/schedule.h"

namespace spoke::graph {

/// Simulates work stealing as oneTBB's flow graphs do it. A processor that ends a cluster goes on
/// with the first of the successors that this makes ready, and spawns the others: they go to its
/// ready deque, from which it takes the latest first. So a single processor runs the clusters in
/// depth-first order. A processor without work tries to steal from the deques of the others in
/// turn, and takes the oldest cluster there. Clusters without predecessors are spawned by processor
/// 0.
///
/// The simulation goes from event to event, in near-linear time.
Schedule simulate_work_stealing(const Plan& plan, std::span<const double> node_costs,
                                int processors, const Overheads& overheads);

}  // namespace spoke::graph
