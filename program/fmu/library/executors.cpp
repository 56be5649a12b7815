// The executors of an FMU: importers run many of them side by side, on threads of their own, so all
// are serial. These functions stand in for those of graph/ that know oneTBB and OpenMP: the library
// of an FMU needs neither.

#include "graph/calibrate/capacity.h"
#include "graph/execute/executor_kinds.h"
#include "graph/executor.h"
#include "graph/tune/auto_executor.h"

namespace spoke::graph {

void check_thread_limit(ExecutorKind, const Threads&) {}

std::unique_ptr<Executor> make_executor(const StepGraph& graph, ExecutorKind, Threads) {
  return make_serial_executor(graph);
}

std::unique_ptr<Executor> make_auto_executor(const StepGraph& graph, int, Expectation) {
  return make_serial_executor(graph);
}

double measure_capacity(int, double) { return 1.0; }

}  // namespace spoke::graph
