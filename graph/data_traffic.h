#pragma once

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// What bringing data from another processor takes.
struct Transfer {
  double latency = 0.0;   ///< until the first of it is there [s]
  double per_byte = 0.0;  ///< [s/byte]
};

/// Which processor holds which part of a graph's data in its caches, in a simulated run: the one
/// that touched it last. A node that touches parts held by another processor waits for them: once
/// for the first of the data, and in proportion to their size. Parts without memory cost nothing.
class DataTraffic {
 public:
  DataTraffic(const StepGraph& graph, const Transfer& transfer);

  /// Lets `processor` run `node`; returns how long it waits for the node's data [s].
  double run(NodeId node, int processor);

 private:
  const StepGraph& graph_;
  double latency_;
  std::vector<double> seconds_;  // per part, without the latency
  std::vector<int> holders_;     // per part, -1: nobody yet
};

}  // namespace spoke::graph
