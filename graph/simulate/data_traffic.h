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

/// Until others have given up their copies of what a node has written, its processor waits ...
enum class Writing {
  at_once,      ///< as locked instructions make it, of which oneTBB runs some after each node
  at_barriers,  ///< where DataTraffic is told of them
};

/// Which processors hold which part of a graph's data in their caches, in a simulated run: the one
/// that wrote it last, and those that have read it since. A node whose processor does not hold all
/// that it reads and writes waits for it: for the first cache line of each part, as far as these
/// waits do not overlap, and in proportion to the number of lines, of a part of many records that
/// of one. Parts without memory cost nothing.
class DataTraffic {
 public:
  DataTraffic(const StepGraph& graph, const Transfer& transfer, Writing writing = Writing::at_once);

  /// Lets `processor` run `node`, which takes `cost` with all data at hand; returns how long it
  /// waits for them [s].
  double run(NodeId node, int processor, double cost);
  /// Lets `processor` come to a barrier; returns how long it waits for others to give up their
  /// copies of what it has written since the last one [s].
  double wait_at_barrier(int processor);
  /// Of what the runtime keeps of a cluster of the plan that is run, two neighbouring cache lines
  /// change in each run. One when a predecessor on `processor` tells the cluster that it has ended,
  double notify(int cluster, int processor);
  /// and one when `processor` starts the cluster. Both return how long it waits for the line, from
  /// the processor that changed it last [s]. Who told a cluster last has its neighbour, too.
  double start_cluster(int cluster, int processor);

 private:
  bool fetch(std::size_t part, int processor);
  bool is_copied(std::size_t part) const;

  const StepGraph& graph_;
  Writing writing_;
  double latency_;
  double line_;                            // until a single cache line is there [s]
  std::vector<double> seconds_;            // per part, without the latency
  std::vector<std::vector<int>> holders_;  // per part; of data that nobody has touched yet, empty
  std::vector<char> is_to_wait_;           // per processor, at its next barrier
  std::vector<int> tellers_;               // per cluster the processor that told it last, or -1
  std::vector<int> starters_;              // and that started it last
};

}  // namespace spoke::graph
