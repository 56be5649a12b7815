#pragma once

// The graph as loops over subsystems and, within them, over bodies, for the nested OpenMP
// executors.

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// Nodes that one thread runs one after the other.
using NodeChain = std::vector<NodeId>;

/// A stretch of one subsystem: nodes that the first thread of its team runs alone, then a loop over
/// bodies and items of bodies (NodeLabel::item), whose chains are independent of each other.
struct BodyLoop {
  NodeChain alone;
  std::vector<NodeChain> bodies;
};

/// The work of one subsystem: loops with a barrier of its team after each.
using SubsystemWork = std::vector<BodyLoop>;

/// A stretch of the graph: nodes that the first of all threads runs alone, then a loop over
/// subsystems that are independent of each other, with a barrier of all threads after it.
struct SubsystemLoop {
  NodeChain alone;
  std::vector<SubsystemWork> subsystems;
};

/// Derives the loops that a programmer with nested teams of threads would write, from nothing but
/// the coordinates (NodeLabel) and edges of its nodes. The order of insertion is kept except among
/// independent nodes, so all edges of any graph are honoured: where one connects subsystems or
/// bodies within a loop, a new loop begins. Nodes of no subsystem are run alone.
std::vector<SubsystemLoop> derive_nested_loops(const StepGraph& graph);

}  // namespace spoke::graph
