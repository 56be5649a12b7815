#pragma once

// Tells the thread sanitizer about the graph's edges, where the runtime is built without it.

#include "graph/step_graph.h"

#ifdef SPOKE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

// Runtimes such as oneTBB are not built with the thread sanitizer: it does not see how they hand
// work from thread to thread, and takes every handover for a race; nor does it see that the memory
// of an ended OpenMP task goes to the next one. An executor on such a runtime stays out of the
// sanitizer (graph/CMakeLists.txt) and tells it instead only what the graph's edges promise: that a
// node comes after its predecessors, nodes without predecessors after the start of the run, and the
// end of the run after all. Any report about the bodies of nodes is then a conflict that no edge
// orders. In other builds these functions cost nothing.

namespace spoke::graph {

namespace thread_sanitizer {

#ifdef SPOKE_THREAD_SANITIZER
/// Everything before `place` was released happens before everything after its acquisition.
inline void release(const void* place) { __tsan_release(const_cast<void*>(place)); }
inline void acquire(const void* place) { __tsan_acquire(const_cast<void*>(place)); }
#else
inline void release(const void*) {}
inline void acquire(const void*) {}
#endif

}  // namespace thread_sanitizer

/// Tells the start of a run; to be called on the calling thread before the first node runs.
inline void tell_start([[maybe_unused]] const StepGraph& graph) {
  thread_sanitizer::release(&graph);
}

/// Runs one node. The graph's edges, tell_start() and tell_end() order its run.
inline void run_told(const StepGraph& graph, NodeId node) noexcept {
#ifdef SPOKE_THREAD_SANITIZER
  const auto predecessors = graph.predecessors(node);
  if (predecessors.empty()) thread_sanitizer::acquire(&graph);
  for (const NodeId before : predecessors) thread_sanitizer::acquire(&graph.node(before));
#endif
  graph.run_node(node);
  thread_sanitizer::release(&graph.node(node));
}

/// Tells the end of a run; to be called on the calling thread after the last node has run.
inline void tell_end([[maybe_unused]] const StepGraph& graph) {
#ifdef SPOKE_THREAD_SANITIZER
  for (int i = 0; i < graph.node_count(); ++i) {
    if (graph.successors({i}).empty()) thread_sanitizer::acquire(&graph.node({i}));
  }
#endif
}

}  // namespace spoke::graph
