#include "graph/executor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "graph/cgroup_processors.h"
#include "graph/executor_kinds.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace spoke::graph {
namespace {

int processors_of_affinity() {
#ifdef __linux__
  // The kernel refuses a mask that is too short for the machine: try longer ones.
  for (int bits = CPU_SETSIZE; bits <= (1 << 20); bits *= 2) {
    const std::size_t bytes = CPU_ALLOC_SIZE(bits);
    const std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> mask(
        CPU_ALLOC(bits), [](cpu_set_t* set) { CPU_FREE(set); });
    if (mask && sched_getaffinity(0, bytes, mask.get()) == 0) {
      return CPU_COUNT_S(bytes, mask.get());
    }
  }
#endif
  return static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

int available_threads() {
  int threads = processors_of_affinity();
  std::ifstream membership("/proc/self/cgroup");
  if (const auto limit = cgroup_processors(membership, "/sys/fs/cgroup")) {
    threads = static_cast<int>(std::min<double>(threads, std::ceil(*limit)));
  }
  return std::max(threads, 1);
}

std::string name_of(const Threads& threads) {
  std::string name = std::to_string(threads.outer);
  if (threads.inner != 1) name += 'x' + std::to_string(threads.inner);
  return name;
}

void Executor::run_while(const std::function<bool()>& more) {
  do run();
  while (more());
}

std::string Executor::describe() const {
  const Threads count = threads();
  return std::string(name()) + " on " + name_of(count) + (count == 1 ? " thread" : " threads");
}

std::span<const ExecutorKind> executor_kinds() {
  static constexpr std::array kinds{ExecutorKind::automatic, ExecutorKind::flow_graph,
                                    ExecutorKind::serial};
  return kinds;
}

std::string_view name_of(ExecutorKind kind) {
  switch (kind) {
    case ExecutorKind::automatic:
      return "auto";
    case ExecutorKind::flow_graph:
      return "flow_graph";
    case ExecutorKind::serial:
      return "serial";
  }
  return "unknown";
}

std::unique_ptr<Executor> make_executor(const StepGraph& graph, ExecutorKind kind,
                                        Threads threads) {
  if (threads.outer < 0 || threads.inner < 1) {
    throw std::invalid_argument("number of threads: expected 0 (all available) or more, got " +
                                name_of(threads));
  }
  if (threads.inner != 1) {
    throw std::invalid_argument(std::string(name_of(kind)) +
                                " has one layer of threads, expected a number, got " +
                                name_of(threads));
  }
  if (threads.outer == 0) threads.outer = available_threads();
  switch (kind) {
    case ExecutorKind::automatic:
      return make_auto_executor(graph, threads.outer);
    case ExecutorKind::serial:
      return make_serial_executor(graph);
    case ExecutorKind::flow_graph:
      return make_flow_graph_executor(graph, plan_of_single_nodes(graph), threads.outer);
  }
  throw std::invalid_argument("unknown kind of executor");
}

}  // namespace spoke::graph
