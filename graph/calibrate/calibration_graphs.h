#pragma once

// Small graphs on which the costs of runtimes are measured, none of them a model's.

#include "graph/step_graph.h"

namespace spoke::graph {

/// `count` times one node that two busy ones wait for; a last one joins the last of them.
StepGraph make_fork_joins(int count, double busy);

/// Levels of two empty nodes, each of which waits for both nodes of the level before.
StepGraph make_ladder(int levels);

}  // namespace spoke::graph
