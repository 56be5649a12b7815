#pragma once

// Derives the graph as rounds of levels, for openmp_levels.

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// The work between two barriers: for each thread a list of nodes, to be run in this order.
using Round = std::vector<std::vector<NodeId>>;

/// Returns the graph level by level: a node's level is the number of edges on the longest path to
/// it, the nodes of a level are shared out in contiguous, equal numbers, and a barrier stands
/// between two levels unless all edges since the last one stay within a thread.
std::vector<Round> derive_level_rounds(const StepGraph& graph, int threads);

/// Returns whether only the first thread works in the last of several rounds.
bool ends_alone(const std::vector<Round>& rounds);

}  // namespace spoke::graph
