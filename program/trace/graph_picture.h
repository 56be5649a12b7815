#pragma once

// The step graph as a picture, coloured by time.

#include <string>

#include "program/trace/trace.h"

namespace spoke::trace {

/// Returns the text of graph.dot: the graph of one pass for Graphviz, nodes coloured by their share
/// of the time, with their mean costs, the longest path of mean costs marked. A graph of more than
/// 1000 nodes is drawn by groups of nodes: the clusters of the executor's plan in the middle step,
/// or if it has none, or still too many, the nodes of a subsystem and stage, or of a stage.
/// Precondition: there is a step.
std::string make_dot(const Trace& trace);

}  // namespace spoke::trace
