#pragma once

// Data that move between processors, in a simulated run.

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// What bringing data from another processor takes.
struct Transfer {
  double latency = 0.0;   ///< until the first of it is there [s]
  double per_byte = 0.0;  ///< [s/byte]
};

/// Which processors hold which part of a graph's data in their caches, in a simulated run: the one
/// that wrote it last, and those that have read it since. A node waits for each part that it reads
/// or writes and its processor does not hold; of a part of many records for one. Parts without
/// memory cost nothing.
class DataTraffic {
 public:
  /// Refers to `graph`, which must outlive it.
  DataTraffic(const StepGraph& graph, const Transfer& transfer);

  /// Lets `processor` run `node`; returns how long it waits for data [s].
  double run(NodeId node, int processor);

 private:
  double fetch(PartId part, int processor);

  const StepGraph& graph_;
  std::vector<double> seconds_;            // that each part takes
  std::vector<std::vector<int>> holders_;  // per part; of data that nobody has touched yet, empty
};

}  // namespace spoke::graph
