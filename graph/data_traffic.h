#pragma once

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// Which processor holds which part of a graph's data in its caches, in a simulated run: the one
/// that touched it last. A node that touches a part held by another processor waits for it, in
/// proportion to its size. Parts without memory cost nothing.
class DataTraffic {
 public:
  /// `seconds_per_byte`: what bringing data from another processor takes [s/byte].
  DataTraffic(const StepGraph& graph, double seconds_per_byte);

  /// Lets `processor` run `node`; returns how long it waits for the node's data [s].
  double run(NodeId node, int processor);

 private:
  const StepGraph& graph_;
  std::vector<double> seconds_;  // per part
  std::vector<int> holders_;     // per part, -1: nobody yet
};

}  // namespace spoke::graph
