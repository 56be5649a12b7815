// Names and checks of kinds and numbers of threads.

#include "graph/executor.h"

#include <algorithm>
#include <array>
#include <string>

#include "spoke/error.h"

namespace spoke::graph {
namespace {

#ifdef SPOKE_HAS_OPENMP
constexpr bool kHasOpenMp = true;
#else
constexpr bool kHasOpenMp = false;
#endif

// Kinds that need OpenMP stand last.
constexpr std::array kKinds{ExecutorKind::automatic,      ExecutorKind::flow_graph,
                            ExecutorKind::serial,         ExecutorKind::openmp_scheme1,
                            ExecutorKind::openmp_scheme2, ExecutorKind::openmp_levels,
                            ExecutorKind::openmp_tasks};
constexpr std::size_t kOpenMpKinds = 4;

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

}  // namespace

bool is_openmp(ExecutorKind kind) {
  const auto kinds = std::span(kKinds).last(kOpenMpKinds);
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool has_nested_teams(ExecutorKind kind) {
  return kind == ExecutorKind::openmp_scheme1 || kind == ExecutorKind::openmp_scheme2;
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
    case ExecutorKind::openmp_tasks:
      return "openmp_tasks";
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

}  // namespace spoke::graph
