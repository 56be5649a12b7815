#pragma once

// Measures the costs of the runtimes under the executors on this machine.

#include "graph/simulate/schedule.h"

namespace spoke::graph {

/// The costs of the runtimes under the executors on a machine, beside those of the nodes [s].
struct RuntimeCosts {
  Overheads flow_graph;
  double barrier = 0.0;        ///< an OpenMP barrier of two threads; 0: no OpenMP, not known
  double barrier_alone = 0.0;  ///< a barrier of a team of one thread
};

/// Measures the costs on graphs of empty and of busy nodes, in about a tenth of a second. Results
/// are bounded to plausible values, for busy machines. Threads of OpenMP spin on for some
/// milliseconds after that.
RuntimeCosts measure_runtime_costs();

}  // namespace spoke::graph
