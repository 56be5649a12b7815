#pragma once

// The executor "auto": which plan runs a graph, and whether other threads are worth it.

#include <memory>
#include <vector>

#include "graph/executor.h"

namespace spoke::graph {

/// What is known of a graph before its first run.
struct Expectation {
  std::vector<double> node_costs;  ///< by index of the node [s]; empty: measured on the first runs
  double seconds = 0.0;            ///< that all its runs will take serially; 0: not known
  bool threads_are_worth = false;  ///< as was measured just now; else it will be
};

/// Goes parallel at once by the plan that the simulator predicts to be fastest, if a probe of the
/// machine shows that other threads are worth it, and serially else. While it runs, each run is
/// timed: other plans take turns, and a plan that turns out slower than serial runs is left, to be
/// tried again later. All of that together, planning included, may cost 2 % of the time that the
/// runs take or are expected to take. Refers to `graph`, which must outlive it.
/// Precondition: threads >= 1.
std::unique_ptr<Executor> make_auto_executor(const StepGraph& graph, int threads,
                                             Expectation expectation = {});

}  // namespace spoke::graph
