#pragma once

// What the runtimes under the executors cost on this machine.

#include "graph/simulate/schedule.h"

namespace spoke::graph {

/// What the runtimes under the executors cost on a machine, beside the nodes [s].
struct RuntimeCosts {
  Overheads flow_graph;
  double barrier = 0.0;        ///< an OpenMP barrier of two threads; 0: no OpenMP, not known
  double barrier_alone = 0.0;  ///< of a team of one thread
};

/// Measured on graphs of empty nodes and of busy ones, none of them a model's, in about a tenth of
/// a second. Bounded to what is plausible, for busy machines. Threads of OpenMP spin on for some
/// milliseconds after that.
RuntimeCosts measure_runtime_costs();

}  // namespace spoke::graph
