#pragma once

// Traces one run of a graph: which thread ran which node when. Simulation::trace() makes traces of
// whole steps.

#include <vector>

#include "graph/executor.h"
#include "spoke/export.h"

namespace spoke::graph {

/// One run of a node.
struct NodeRun {
  NodeId node;         ///< node of the graph
  int thread = 0;      ///< thread of the executor; 0: the one that called it
  double begin = 0.0;  ///< beginning, from the start of the run [s]
  double end = 0.0;    ///< end, from the start of the run [s]
};

/// One run of a graph.
struct RunTrace {
  std::vector<NodeRun> nodes;  ///< each node once, sorted by begin
  double duration = 0.0;       ///< time from before the first node to after the last [s]
};

/// Runs `graph` once by `executor`, which make_executor() has made for it, and records which thread
/// runs which node when. An executor that chooses runs on the calling thread until it has chosen,
/// as it does under Executor::set_recorder(), and has no recorder afterwards.
SPOKE_EXPORT RunTrace trace_run(const StepGraph& graph, Executor& executor);

}  // namespace spoke::graph
