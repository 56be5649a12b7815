#include "tests/graph/recorded_graph.h"

namespace spoke::graph::testing {

RecordedGraph::RecordedGraph(const GraphPlan& plan)
    : records_(plan.nodes.size()), graph_(build(plan)) {}

int RecordedGraph::count_nodes_not_run(int times) const {
  int count = 0;
  for (const Record& record : records_) count += record.runs != times ? 1 : 0;
  return count;
}

int RecordedGraph::count_edges_out_of_order() const {
  int count = 0;
  for (int i = 0; i < graph_.node_count(); ++i) {
    for (const NodeId before : graph_.predecessors({i})) {
      const Record& first = records_[static_cast<std::size_t>(before.index)];
      count += first.end >= records_[static_cast<std::size_t>(i)].start ? 1 : 0;
    }
  }
  return count;
}

StepGraph RecordedGraph::build(const GraphPlan& plan) {
  StepGraphBuilder builder;
  for (std::size_t i = 0; i < plan.memory.size(); ++i)
    builder.add_part("part " + std::to_string(i), {});
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    const NodePlan& node = plan.nodes[i];
    builder.add_node(node.label, reads(node.reads), writes(node.writes), [this, i]() noexcept {
      records_[i].start = clock_++;
      ++records_[i].runs;
      records_[i].end = clock_++;
    });
  }
  return builder.build();
}

}  // namespace spoke::graph::testing
