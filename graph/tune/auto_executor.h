#pragma once

// The executor "auto", which chooses the plan that runs a graph, on one thread or several.

#include <memory>
#include <vector>

#include "graph/executor.h"

namespace spoke::graph {

/// Estimates about a graph before its first run.
struct Expectation {
  /// Costs by index of the node [s]; empty: measured on the first runs.
  std::vector<double> node_costs;
  double seconds = 0.0;  ///< time that all its runs will take serially; 0: not known
  /// Whether a measurement just now found other threads worth it; if false, it is measured.
  bool threads_are_worth = false;
};

/// Goes parallel at once by the plan that the simulator predicts to be fastest, if a probe of the
/// machine shows that other threads are worth it, otherwise serially. While it runs, each run is
/// timed: other plans take turns, and a plan that turns out slower than serial runs is left, to be
/// tried again later. All of that together, planning included, may cost 2 % of the time that the
/// runs take or are expected to take. Refers to `graph`, which must outlive it. Precondition:
/// threads >= 1.
std::unique_ptr<Executor> make_auto_executor(const StepGraph& graph, int threads,
                                             Expectation expectation = {});

}  // namespace spoke::graph
