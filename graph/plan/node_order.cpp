// Sorts the nodes by level or depth first.

#include "graph/plan/node_order.h"

#include "graph/plan/level_rounds.h"

namespace spoke::graph {

std::vector<NodeId> make_order(const StepGraph& graph, NodeOrder order) {
  if (order == NodeOrder::serial) return {graph.serial_order().begin(), graph.serial_order().end()};
  std::vector<NodeId> nodes;
  for (const Round& round : derive_level_rounds(graph, 1))
    nodes.insert(nodes.end(), round.front().begin(), round.front().end());
  return nodes;
}

}  // namespace spoke::graph
