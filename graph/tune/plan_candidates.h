#pragma once

// Plans that may be worth running on several processors.

#include <cstddef>
#include <span>
#include <vector>

#include "graph/plan/plan.h"
#include "graph/simulate/schedule.h"

namespace spoke::graph {

struct Candidate {
  Plan plan;
  double makespan = 0.0;  ///< simulated time, overheads included [s]
};

/// Finds plans worth trying on `processors`, at most `most`, the fastest first: from a small grid
/// of coarsening options, each both for work stealing as it is and in wrap-around order, scored by
/// simulated work stealing. Plans that one thread would run, of one cluster or a chain of clusters,
/// are not among them. `node_costs` by index of the node [s]. Takes some microseconds a node.
/// Preconditions: a cost per node, processors >= 1.
std::vector<Candidate> find_candidates(const StepGraph& graph, std::span<const double> node_costs,
                                       int processors, const Overheads& overheads,
                                       std::size_t most);

/// Returns the least gain [1 = none] for which other threads are worth it. A run of few handovers'
/// length loses most when other programs take a processor, so it must promise more.
/// `seconds_per_run` and `handover` in seconds.
double least_gain(double seconds_per_run, double handover);

}  // namespace spoke::graph
