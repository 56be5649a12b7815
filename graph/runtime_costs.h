#pragma once

#include "graph/schedule_simulator.h"

namespace spoke::graph {

/// What the runtimes under the executors cost on a machine, beside the nodes [s].
struct RuntimeCosts {
  Overheads flow_graph;
  double flow_graph_run = 0.0;  ///< starting a run of the flow graph and waiting for its end
  double barrier = 0.0;         ///< an OpenMP barrier of two threads; 0: no OpenMP, not known
  double barrier_alone = 0.0;   ///< of a team of one thread
};

/// Measured once per process on graphs of empty nodes and of nodes of 20 us, none of them a
/// model's, in some milliseconds. Bounded to what is plausible, for busy machines.
const RuntimeCosts& runtime_costs();

/// All of them times `factor`.
RuntimeCosts scaled(const RuntimeCosts& costs, double factor);

}  // namespace spoke::graph
