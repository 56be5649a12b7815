#pragma once

// What the slices of a trace say of work, span and idle threads.

#include <cstdint>
#include <vector>

#include "engine/step_trace.h"
#include "engine/support/machine.h"

namespace spoke::trace {

/// Of one step [s].
struct StepTimes {
  std::int64_t step = 0;
  double work = 0.0;      ///< T1: the sum of its slices
  double span = 0.0;      ///< Tinf: the longest path through its passes, of durations as they were
  double makespan = 0.0;  ///< from its first begin to its last end
};

/// One for each step of the trace, in their order.
std::vector<StepTimes> time_steps(const StepTrace& trace);

/// Of a typical step. Where steps overlap (see overlap()), elapsed time is the mean per step.
struct Summary {
  double work = 0.0;     ///< T1, median [s]
  double span = 0.0;     ///< Tinf, median [s]
  double elapsed = 0.0;  ///< makespan, median [s]
  /// What no schedule is faster than: max(T1/P, Tinf); where steps overlap T1/P, for the longest
  /// path of one step may lie beside those of others [s].
  double bound = 0.0;
  double speedup = 0.0;  ///< work / elapsed
  double idle = 0.0;     ///< share of the threads' time in which they ran no node
};
/// Of a typical step the bound with what the threads really do at once instead of their number [s].
/// Precondition: capacity.is_known().
double bound_at_capacity(const StepTrace& trace, const Summary& summary, const Capacity& capacity);

/// Precondition: there is a step.
Summary summarise(const StepTrace& trace);

/// Whether a step begins before the one before it has ended.
bool overlap(const StepTrace& trace);

/// By node its mean cost in the passes that had something to do [s]; 0 of a node without any.
std::vector<double> mean_costs(const StepTrace& trace);

/// By node the share of all nodes' time that it took.
std::vector<double> time_shares(const StepTrace& trace);

/// The nodes of a longest path through an acyclic graph, from its first to its last; `costs` by
/// node.
std::vector<int> longest_path(const std::vector<NodeEdge>& edges, const std::vector<double>& costs);

}  // namespace spoke::trace
