#include "graph/executor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include "graph/affinity.h"
#include "graph/cgroup_processors.h"
#include "graph/executor_kinds.h"
#include "graph/thread_trial.h"
#include "graph/unbound_thread.h"
#include "spoke/error.h"

#ifdef SPOKE_HAS_OPENMP
#include "graph/openmp_runtime.h"
#endif

namespace spoke::graph {
namespace {

// Those the process started with: the OpenMP runtime may have bound the calling thread to one.
int processors_of_process() {
#ifdef SPOKE_HAS_OPENMP
  if (const auto binding = openmp_binding()) return binding->processors;
#endif
  const std::size_t count = thread_affinity().size();
  return count > 0 ? static_cast<int>(count)
                   : static_cast<int>(std::thread::hardware_concurrency());
}

#ifdef SPOKE_HAS_OPENMP
constexpr bool kHasOpenMp = true;
#else
constexpr bool kHasOpenMp = false;
#endif

// Those that need OpenMP stand last.
constexpr std::array kKinds{ExecutorKind::automatic,      ExecutorKind::flow_graph,
                            ExecutorKind::serial,         ExecutorKind::openmp_scheme1,
                            ExecutorKind::openmp_scheme2, ExecutorKind::openmp_levels};
constexpr std::size_t kOpenMpKinds = 3;

std::string known_names() {
  std::string names;
  for (const ExecutorKind kind : executor_kinds()) {
    if (!names.empty()) names += ", ";
    names += name_of(kind);
  }
  return names;
}

void check_in_build(ExecutorKind kind) {
  if (has_executor(kind)) return;
  throw InputError(std::string(name_of(kind)) +
                   " needs OpenMP, which this build is without (SPOKE_OPENMP=OFF); known here: " +
                   known_names());
}

std::string kinds_of_nested_teams() {
  std::string names;
  for (const ExecutorKind kind : executor_kinds()) {
    if (!has_nested_teams(kind)) continue;
    names += names.empty() ? " (" : " and ";
    names += name_of(kind);
  }
  return names.empty() ? names : names + " take two)";
}

#ifdef SPOKE_HAS_OPENMP
// OpenMP's runtimes end the program if the system refuses them a thread: that shows here.
void try_if_many(const Threads& threads) {
  if (threads.total() > processors_of_process()) try_threads(threads.total());
}
#endif

}  // namespace

bool is_openmp(ExecutorKind kind) {
  const auto kinds = std::span(kKinds).last(kOpenMpKinds);
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool has_nested_teams(ExecutorKind kind) {
  return kind == ExecutorKind::openmp_scheme1 || kind == ExecutorKind::openmp_scheme2;
}

int available_threads() {
  int threads = processors_of_process();
  std::ifstream membership("/proc/self/cgroup");
  if (const auto limit = cgroup_processors(membership, "/sys/fs/cgroup")) {
    threads = static_cast<int>(std::min<double>(threads, std::ceil(*limit)));
  }
  return std::clamp(threads, 1, kMostThreads);
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
  const Threads count = threads(), working = recorded_threads();
  std::string text = std::string(name()) + " on " + name_of(count);
  text += count == 1 ? " thread" : " threads";
  if (working.total() < count.total()) text += ", " + name_of(working) + " at work";
  return text;
}

std::span<const ExecutorKind> executor_kinds() {
  return std::span(kKinds).first(kHasOpenMp ? kKinds.size() : kKinds.size() - kOpenMpKinds);
}

bool has_executor(ExecutorKind kind) {
  const auto kinds = executor_kinds();
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::string_view name_of(ExecutorKind kind) {
  switch (kind) {
    case ExecutorKind::automatic:
      return "auto";
    case ExecutorKind::flow_graph:
      return "flow_graph";
    case ExecutorKind::serial:
      return "serial";
    case ExecutorKind::openmp_scheme1:
      return "openmp_scheme1";
    case ExecutorKind::openmp_scheme2:
      return "openmp_scheme2";
    case ExecutorKind::openmp_levels:
      return "openmp_levels";
  }
  return "unknown";
}

ExecutorKind executor_kind(std::string_view name) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [name](ExecutorKind k) { return name_of(k) == name; });
  if (kind == kKinds.end()) {
    throw InputError("no executor is named \"" + std::string(name) +
                     "\"; known here: " + known_names());
  }
  check_in_build(*kind);
  return *kind;
}

void check_threads(ExecutorKind kind, const Threads& threads) {
  if (threads.outer < 0 || threads.inner < 1) {
    throw InputError("number of threads: expected 0 (all available) or more, got " +
                     name_of(threads));
  }
  if (threads.outer > kMostThreads || threads.inner > kMostThreads / std::max(threads.outer, 1)) {
    throw InputError("number of threads: expected at most " + std::to_string(kMostThreads) +
                     " in all, got " + name_of(threads));
  }
  if (threads.inner != 1 && !has_nested_teams(kind)) {
    throw InputError(std::string(name_of(kind)) +
                     " has one layer of threads, expected a number, got " + name_of(threads) +
                     kinds_of_nested_teams());
  }
}

void check_thread_limit([[maybe_unused]] ExecutorKind kind,
                        [[maybe_unused]] const Threads& threads) {
#ifdef SPOKE_HAS_OPENMP
  if (is_openmp(kind)) check_openmp_limit(kind, threads);
#endif
}

std::unique_ptr<Executor> make_executor(const StepGraph& graph, ExecutorKind kind,
                                        Threads threads) {
  check_in_build(kind);
  check_threads(kind, threads);
  if (threads.outer == 0) {
    threads.outer = available_threads();
    check_threads(kind, threads);
  }
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
      return make_openmp_scheme1_executor(graph, threads, processors_for_openmp());
    case ExecutorKind::openmp_scheme2:
      try_if_many(threads);
      return make_openmp_scheme2_executor(graph, threads);
    case ExecutorKind::openmp_levels:
      try_if_many(threads);
      return make_openmp_levels_executor(graph, threads.outer);
#else
    default:
      break;
#endif
  }
  throw InputError("unknown kind of executor");
}

}  // namespace spoke::graph
