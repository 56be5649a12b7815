#pragma once

#include <atomic>
#include <vector>

#include "tests/graph/arithmetic_graph.h"

namespace spoke::graph::testing {

/// The graph of a plan whose nodes only record when they run.
class RecordedGraph {
 public:
  explicit RecordedGraph(const GraphPlan& plan);

  const StepGraph& graph() const { return graph_; }

  int count_nodes_not_run(int times) const;
  /// Counts edges whose second node began, in the last run, before the first had ended.
  int count_edges_out_of_order() const;

 private:
  // The number of times a node ran, and its place in the order of starts and ends of the last run.
  struct Record {
    std::atomic<int> runs{0};
    std::atomic<int> start{0};
    std::atomic<int> end{0};
  };

  StepGraph build(const GraphPlan& plan);

  std::atomic<int> clock_{0};
  std::vector<Record> records_;
  StepGraph graph_;
};

}  // namespace spoke::graph::testing
