#pragma once

// Predicts the time of a run on any number of processors.

#include <vector>

#include "graph/plan/plan.h"
#include "graph/simulate/schedule.h"

namespace spoke::graph {

/// How the executor auto would run a graph.
struct AutoRun {
  double seconds = 0.0;  ///< of a run [s]
  int clusters = 1;      ///< of the plan that is run; 1: serially
};

/// Predicts how long runs of a graph take on processors equal to the one on which its nodes were
/// timed. The movement of data between processors, and resources they share, are not modelled.
class RunPredictor {
 public:
  /// Refers to `graph`, which must outlive the predictor. `node_costs`: costs on one thread, by
  /// index of the node [s].
  RunPredictor(const StepGraph& graph, std::vector<double> node_costs);

  double work() const;  ///< T1 [s]
  double span() const;  ///< Tinf [s]

  /// Returns the time of a list schedule of single nodes [s]: a processor that ends a node goes on
  /// with one that this makes ready, and one without work takes the oldest that another offers.
  /// Precondition: processors >= 1.
  double schedule(int processors, const Overheads& overheads) const;

  /// Returns what the executor auto would take on so many threads, each with a processor of its
  /// own: the fastest of the plans that it would make, or serially if none gains as much as it asks
  /// for. Precondition: threads >= 1.
  AutoRun choose(int threads) const;

 private:
  const StepGraph& graph_;
  std::vector<double> node_costs_;
  Plan single_nodes_;
};

}  // namespace spoke::graph
