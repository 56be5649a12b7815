#pragma once

#include "graph/schedule_simulator.h"

namespace spoke::graph {

/// What the flow graph's clusters cost on this machine, measured on small graphs of its own, in a
/// few milliseconds: starting a cluster on forks and joins of empty nodes, a handover on a fork and
/// join of two nodes of 20 us. Bounded to what is plausible, for busy machines.
Overheads measure_flow_graph_overheads();

/// The same, measured once per process.
const Overheads& flow_graph_overheads();

}  // namespace spoke::graph
