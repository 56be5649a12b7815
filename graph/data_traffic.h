#pragma once

#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// What bringing data from another processor takes.
struct Transfer {
  double latency = 0.0;   ///< until the first of it is there [s]
  double per_byte = 0.0;  ///< [s/byte]
};

/// While others give up their copies of what a node writes, its processor ...
enum class Writing {
  goes_on,  ///< with what comes next
  waits,    ///< as locked instructions make it, of which oneTBB runs some after each node
};

/// Which processors hold which part of a graph's data in their caches, in a simulated run: the one
/// that wrote it last, and those that have read it since. A node whose processor does not hold all
/// that it reads and writes waits for it: once for the first of the data, and in proportion to
/// their size, of a part of many records to that of one. Parts without memory cost nothing.
class DataTraffic {
 public:
  DataTraffic(const StepGraph& graph, const Transfer& transfer, Writing writing = Writing::goes_on);

  /// Lets `processor` run `node`; returns how long it waits for the node's data [s].
  double run(NodeId node, int processor);
  /// Lets `processor` start a cluster of the plan that is run; returns how long it waits for what
  /// the runtime keeps of the cluster, from the processor that started it last [s]: of a node of
  /// oneTBB's flow graph two cache lines, which each run writes, not both at once.
  double start_cluster(int cluster, int processor);

 private:
  bool fetch(std::size_t part, int processor);
  bool is_copied(std::size_t part) const;

  const StepGraph& graph_;
  Writing writing_;
  double latency_;
  double cluster_record_;                  // of what the runtime keeps of a cluster [s]
  std::vector<double> seconds_;            // per part, without the latency
  std::vector<std::vector<int>> holders_;  // per part; of data that nobody has touched yet, empty
  std::vector<int> starters_;              // per cluster the processor that started it last, or -1
};

}  // namespace spoke::graph
