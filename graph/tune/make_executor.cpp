// Checks the number of threads and makes the executor of a kind.

#include <algorithm>
#include <memory>

#include "graph/execute/available_threads.h"
#include "graph/execute/executor_kinds.h"
#include "graph/execute/unbound_thread.h"
#include "graph/executor.h"
#include "graph/machine/thread_trial.h"
#include "graph/tune/auto_executor.h"
#include "spoke/error.h"

#ifdef SPOKE_HAS_OPENMP
#include "graph/execute/openmp_runtime.h"
#endif

namespace spoke::graph {
namespace {

#ifdef SPOKE_HAS_OPENMP
// OpenMP's runtimes end the program if the system refuses them a thread: try_threads() finds it out
// before.
void try_if_many(const Threads& threads) {
  const std::size_t stack = openmp_stack();
  if (stack > 0 || threads.total() > processors_of_process()) try_threads(threads.total(), stack);
}
#endif

}  // namespace

void check_thread_limit([[maybe_unused]] ExecutorKind kind,
                        [[maybe_unused]] const Threads& threads) {
#ifdef SPOKE_HAS_OPENMP
  if (is_openmp(kind)) check_openmp_limit(kind, threads);
#endif
}

std::unique_ptr<Executor> make_executor(const StepGraph& graph, ExecutorKind kind,
                                        Threads threads) {
  executor_kind(name_of(kind));  // throws if this build is without it
  check_threads(kind, threads);
  if (threads.outer == 0) {
    threads.outer = available_threads();
    check_threads(kind, threads);
  }
#ifdef SPOKE_HAS_OPENMP
  if (is_openmp(kind)) check_openmp_environment();
#endif
  switch (kind) {
    case ExecutorKind::automatic:
      return make_auto_executor(graph, threads.outer);
    case ExecutorKind::serial:
      return make_serial_executor(graph);
    case ExecutorKind::flow_graph: {
      const UnboundThread unbound;  // oneTBB's threads get the processors that this one has
      return make_flow_graph_executor(graph, plan_of_single_nodes(graph), threads.outer);
    }
#ifdef SPOKE_HAS_OPENMP
    case ExecutorKind::openmp_scheme1:
      // Makes no more than there are processors.
      try_if_many({std::min(threads.total(), processors_for_openmp()), 1});
      return make_openmp_scheme1_executor(graph, threads, processors_for_openmp());
    case ExecutorKind::openmp_scheme2:
      try_if_many(threads);
      return make_openmp_scheme2_executor(graph, threads);
    case ExecutorKind::openmp_levels:
      try_if_many(threads);
      return make_openmp_levels_executor(graph, threads.outer);
    case ExecutorKind::openmp_tasks:
      try_if_many(threads);
      return make_openmp_tasks_executor(graph, threads.outer);
#else
    default:
      break;
#endif
  }
  throw InputError("unknown kind of executor");
}

}  // namespace spoke::graph
