#pragma once

// Orders in which one thread runs the nodes.

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// In which order one thread runs the nodes. In another one they find other data in the caches.
enum class NodeOrder {
  serial,  ///< StepGraph::serial_order(), as the executor serial
  levels,  ///< level by level, as openmp_levels on one thread
};

/// All nodes of `graph`.
std::vector<NodeId> make_order(const StepGraph& graph, NodeOrder order);

}  // namespace spoke::graph
