#pragma once

// What the nodes of a graph cost, from some runs on the calling thread.

#include <cstdint>
#include <vector>

#include "graph/step_graph.h"

namespace spoke::graph {

/// Measures what the nodes of a graph cost, on real runs on the calling thread.
class NodeCosts {
 public:
  /// Refers to `graph`, which must outlive it.
  explicit NodeCosts(const StepGraph& graph) : graph_(graph) {}

  /// Runs every node once, in serial order, with a time stamp between any two.
  void run();

  /// The number of runs so far, and the time they took [s].
  int runs() const { return runs_; }
  double seconds() const { return seconds_; }

  /// Per node its cost [s], less that of the stamp: the mean over the cheaper three quarters of the
  /// runs. That leaves out interruptions, but not that a node may be idle in some runs and busy in
  /// others. Precondition: runs() > 0.
  std::vector<double> costs() const;

 private:
  const StepGraph& graph_;
  std::vector<std::uint64_t> ticks_;  // per run and place in the order
  int runs_ = 0;
  double seconds_ = 0.0;
};

}  // namespace spoke::graph
