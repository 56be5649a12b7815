#pragma once

#include <span>

#include "graph/plan.h"
#include "graph/runtime_costs.h"
#include "graph/step_graph.h"

namespace spoke::graph {

/// By how much a node's cost is believed to vary from one run to the next, as a part of it.
inline constexpr double kVariationOfNodes = 0.1;

/// The time that a run of the flow graph takes by this plan [s], on `threads` threads with a
/// processor each: by simulated work stealing, with data that another processor wrote. The mean of
/// several runs, 4 to 64, in which each node is dearer or cheaper by up to `variation` of its
/// cost. The same result at every call.
double simulate_flow_graph_runs(const StepGraph& graph, const Plan& plan,
                                std::span<const double> node_costs, int threads,
                                const RuntimeCosts& runtime, double variation = kVariationOfNodes);

/// How many runs of so many clusters that simulates.
int simulated_flow_graph_runs(int clusters);

}  // namespace spoke::graph
