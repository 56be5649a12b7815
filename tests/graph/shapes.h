#pragma once

#include <cstdint>
#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph::testing {

/// Makes a graph of empty nodes: root -> `width` chains of `length` nodes -> join.
StepGraph make_fan(int width, int length);

/// Makes a window of `steps` steps of `blades` independent chains: per step and chain a node, a
/// layer of `bodies` nodes, and a node that joins them. Nodes are empty, and there is no root or
/// end.
StepGraph make_window(int steps, int blades, int bodies);

/// Makes such a window where each chain also leads to an end of its own, which nothing waits for,
/// and all chains lead to one node: as in windows whose subsystems take samples, and whose hub only
/// records.
StepGraph make_ended_window(int steps, int blades, int bodies);

/// Returns `cost` for every node [s].
std::vector<double> equal_costs(const StepGraph& graph, double cost);

/// Returns costs of 0 to 20 us, a fifth of them 0 [s].
std::vector<double> random_costs(std::uint32_t seed, const StepGraph& graph);

}  // namespace spoke::graph::testing
