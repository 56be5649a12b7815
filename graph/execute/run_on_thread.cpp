// Runs and records nodes for executors of other programs: the recorder is not public.

#include <cassert>

#include "graph/execute/node_recorder.h"
#include "graph/executor.h"

namespace spoke::graph {

void Executor::run_on_thread(int thread, const StepGraph& graph,
                             std::span<const NodeId> nodes) const noexcept {
  assert(thread >= 0 && thread < threads().total());
  run_nodes(recorder_, thread, -1, nodes, [&graph](NodeId node) { graph.run_node(node); });
}

}  // namespace spoke::graph
