// The costliest path, by one sweep through the nodes.

#include "bench/compare/span.h"

#include <algorithm>
#include <cassert>

namespace spoke::compare {

WorkAndSpan calc_work_and_span(const graph::StepGraph& graph, std::span<const double> costs) {
  assert(costs.size() == static_cast<std::size_t>(graph.node_count()));
  WorkAndSpan result;
  std::vector<double> ends(costs.size());  // cost of the costliest path that ends with each node
  for (int k = 0; k < graph.node_count(); ++k) {
    const auto node = static_cast<std::size_t>(k);
    double begin = 0.0;
    for (const graph::NodeId before : graph.predecessors({k}))
      begin = std::max(begin, ends[static_cast<std::size_t>(before.index)]);
    ends[node] = begin + costs[node];
    result.work += costs[node];
    result.span = std::max(result.span, ends[node]);
  }
  return result;
}

}  // namespace spoke::compare
