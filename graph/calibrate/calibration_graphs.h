#pragma once

// Small graphs on which the costs of runtimes are measured; none belongs to a model.

#include "graph/step_graph.h"

namespace spoke::graph {

/// Makes a graph that has, `count` times, one node that two busy ones wait for; a last node joins
/// the last of them.
StepGraph make_fork_joins(int count, double busy);

/// Makes levels of two empty nodes, each of which waits for both nodes of the level before.
StepGraph make_ladder(int levels);

}  // namespace spoke::graph
