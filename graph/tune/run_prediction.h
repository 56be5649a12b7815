#pragma once

// Predicts the time of a run on any number of processors.

#include <vector>

#include "graph/calibrate/runtime_costs.h"
#include "graph/executor.h"

namespace spoke::graph {

/// The time of one run [s], and the bounds of any greedy schedule: max(T1 / P, Tinf), and
/// (T1 - Tinf) / P + Tinf (Graham 1969).
struct PredictedRun {
  double expected = 0.0;
  double optimistic = 0.0;
  double pessimistic = 0.0;  ///< at least `expected`, by the costs of the runtime
  /// Clusters of the plan that is run; 1: serially; 0: the executor has no plans.
  int clusters = 0;
};

/// Factors by which the costs of nodes may be off.
struct CostSpread {
  double low = 1.0;   ///< <= 1
  double high = 1.0;  ///< >= 1
};

/// Predicts how long executors take for a run on any number of processors, equal to the one on
/// which nodes and runtimes were measured, by the same schedule that the executor auto ranks its
/// plans with: costs of nodes, of clusters, and of handovers. The movement of data between
/// processors, and resources they share, are not modelled. For the bounds nodes are at their
/// cheapest and at their dearest.
class RunPredictor {
 public:
  /// Refers to `graph`, which must outlive the predictor. `node_costs`: costs on one thread, by
  /// index of the node [s].
  RunPredictor(const StepGraph& graph, std::vector<double> node_costs, const RuntimeCosts& runtime,
               CostSpread spread = {});

  double work() const;  ///< T1 [s]
  double span() const;  ///< Tinf [s]

  /// Whether runs of this executor can be predicted: serial, flow_graph, auto, and openmp_levels if
  /// its barrier was measured.
  bool can_predict(ExecutorKind kind) const;
  /// Predicts a run on `threads` threads. Precondition: can_predict(kind), threads >= 1. Each
  /// thread has a processor of its own. `auto` runs the plan that the simulator finds best, or
  /// serially if no plan is faster.
  PredictedRun predict(ExecutorKind kind, int threads) const;

 private:
  PredictedRun within_bounds(double seconds, int threads, int clusters) const;
  PredictedRun predict_plan(const Plan& plan, int threads) const;
  PredictedRun predict_serial() const;
  PredictedRun predict_auto(int threads) const;
  PredictedRun predict_levels(int threads) const;

  const StepGraph& graph_;
  std::vector<double> node_costs_;
  RuntimeCosts runtime_;
  CostSpread spread_;
  Plan single_nodes_;
};

}  // namespace spoke::graph
