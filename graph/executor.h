#pragma once

#include <memory>
#include <string_view>

#include "graph/step_graph.h"

namespace spoke::graph {

/// Runs the nodes of one graph, each after its predecessors, any number of times.
class Executor {
 public:
  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Runs every node once and returns when all are done. One call at a time per executor.
  virtual void run() = 0;
  /// The executor's kind, for reports: "serial", "flow graph".
  virtual std::string_view name() const = 0;
  /// How many threads may work on a run, the calling one included.
  virtual int threads() const = 0;
};

enum class ExecutorKind {
  flow_graph,  ///< a oneTBB flow graph in an arena of its own
  serial,      ///< a loop on the calling thread; `threads` is ignored
};

/// Makes an executor with `threads` threads (0 = available_threads()). It refers to `graph`, which
/// must outlive it and stay in place. Throws std::invalid_argument if `threads` is negative.
std::unique_ptr<Executor> make_executor(const StepGraph& graph, ExecutorKind kind, int threads = 0);

/// How many threads of this process can run at once: the processors of the calling thread's
/// affinity mask, at most the processor quota of its control groups (rounded up). At least 1.
int available_threads();

}  // namespace spoke::graph
