#pragma once

// What other numbers of threads would make of traced steps, by simulation.

#include <vector>

#include "engine/step_trace.h"
#include "graph/step_graph.h"

namespace spoke::trace {

/// Times of a step on a number of threads, each with a processor of its own [s].
struct StepOnThreads {
  int threads = 1;
  double scheduled = 0.0;  ///< by a list schedule of single nodes that costs nothing
  double by_auto = 0.0;    ///< by the plan that the executor auto would take, with what tasks cost
  int clusters = 1;        ///< of that plan; 1: auto would run serially
};

/// What more threads would gain, of the nodes alone: what happens between runs is not in it.
struct MoreThreads {
  int window_steps = 1;  ///< approximate number of steps that a run of the graph makes
  int passes = 1;        ///< that a run of the graph makes
  double work = 0.0;     ///< T1 per step [s]
  double span = 0.0;     ///< Tinf of a run, per step [s]
  std::vector<StepOnThreads> rows = {};

  /// Returns how many times as fast as one thread any number of threads is at most.
  double bound() const { return work / span; }
};

/// Returns the costs of the nodes of `run`, a graph of passes over the graph of `trace` [s]: the
/// mean of the cheaper three quarters of a node's slices, those of surplus passes included, alike
/// in every pass.
std::vector<double> costs_of_run(const StepTrace& trace, const graph::StepGraph& run);

/// Simulates steps like the traced ones, made by runs of `run`, each about `window_steps` long, on
/// each number of threads. Preconditions: a step in the trace; all numbers >= 1.
MoreThreads find_more_threads(const StepTrace& trace, const graph::StepGraph& run, int window_steps,
                              const std::vector<int>& threads);

}  // namespace spoke::trace
