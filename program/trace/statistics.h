#pragma once

// Work, span and idle threads from the slices of a trace.

#include <cstdint>
#include <vector>

#include "engine/step_trace.h"
#include "engine/support/machine.h"

namespace spoke::trace {

/// Times of one step [s].
struct StepTimes {
  std::int64_t step = 0;
  double work = 0.0;      ///< T1: the sum of its slices
  double span = 0.0;      ///< Tinf: the longest path through its passes, by the durations measured
  double makespan = 0.0;  ///< time from its first begin to its last end
};

/// Returns times for each step of the trace, in their order.
std::vector<StepTimes> time_steps(const StepTrace& trace);

/// Times of a typical step. Where steps overlap (see overlap()), elapsed time is the mean per step.
struct Summary {
  double work = 0.0;     ///< T1, median [s]
  double span = 0.0;     ///< Tinf, median [s]
  double elapsed = 0.0;  ///< makespan, median [s]
  /// The time that no schedule is below [s]: max(T1/P, Tinf); where steps overlap T1/P, since the
  /// longest path of one step may lie beside those of others.
  double bound = 0.0;
  double speedup = 0.0;  ///< work / elapsed
  double idle = 0.0;     ///< fraction of the threads' time in which they ran no node
};
/// Returns the bound of a typical step with the measured capacity of the threads in place of their
/// number [s]. Precondition: capacity.is_known().
double bound_at_capacity(const StepTrace& trace, const Summary& summary, const Capacity& capacity);

/// Summarises a trace. Precondition: there is a step.
Summary summarise(const StepTrace& trace);

/// Returns whether a step begins before the one before it has ended.
bool overlap(const StepTrace& trace);

/// Returns by node its mean cost in the passes in which it had work [s]; 0 for a node without any.
std::vector<double> mean_costs(const StepTrace& trace);

/// Returns by node its fraction of all nodes' time.
std::vector<double> time_shares(const StepTrace& trace);

/// Returns the nodes of a longest path through an acyclic graph, from its first to its last;
/// `costs` by node.
std::vector<int> longest_path(const std::vector<NodeEdge>& edges, const std::vector<double>& costs);

}  // namespace spoke::trace
