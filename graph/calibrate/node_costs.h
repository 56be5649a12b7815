#pragma once

// Measures the costs of a graph's nodes in some runs on the calling thread.

#include <cstdint>
#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// Measures the costs of a graph's nodes in real runs on the calling thread.
class NodeCosts {
 public:
  /// Refers to `graph`, which must outlive this object.
  explicit NodeCosts(const StepGraph& graph) : graph_(graph) {}

  /// Runs every node once, in serial order, with a time stamp between any two.
  void run();

  /// Returns the number of runs so far, or the time they took [s].
  int runs() const { return runs_; }
  double seconds() const { return seconds_; }

  /// Returns for each node its cost [s], less that of the stamp: the mean over the cheaper three
  /// quarters of the runs. That leaves out interruptions, but keeps the mean of nodes that are idle
  /// in some runs and busy in others. Precondition: runs() > 0.
  std::vector<double> costs() const;

 private:
  const StepGraph& graph_;
  std::vector<std::uint64_t> ticks_;  // ticks per run and place in the order
  int runs_ = 0;
  double seconds_ = 0.0;
};

}  // namespace spoke::graph
