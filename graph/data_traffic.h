#pragma once

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// What bringing data from another processor takes.
struct Transfer {
  double latency = 0.0;   ///< until the first of it is there [s]
  double per_byte = 0.0;  ///< [s/byte]
};

/// Which processors hold which part of a graph's data in their caches, in a simulated run: the one
/// that wrote it last, and those that have read it since. A node whose processor does not hold all
/// that it reads and writes waits for it: once for the first of the data, and in proportion to
/// their size, of a part of many records to that of one. Parts without memory cost nothing.
class DataTraffic {
 public:
  DataTraffic(const StepGraph& graph, const Transfer& transfer);

  /// Lets `processor` run `node`; returns how long it waits for the node's data [s].
  double run(NodeId node, int processor);

 private:
  bool fetch(std::size_t part, int processor);

  const StepGraph& graph_;
  double latency_;
  std::vector<double> seconds_;            // per part, without the latency
  std::vector<std::vector<int>> holders_;  // per part; of data that nobody has touched yet, empty
};

}  // namespace spoke::graph
