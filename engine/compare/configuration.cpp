#include "engine/compare/configuration.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "models/error.h"

namespace spoke::compare {
namespace {

void append_once(std::vector<graph::Threads>& list, graph::Threads threads) {
  if (std::find(list.begin(), list.end(), threads) == list.end()) list.push_back(threads);
}

/// Powers of two up to what is available, and that; for nested teams also a thread per subsystem,
/// alone and with small teams, as long as the processors are not oversubscribed beyond sense.
std::vector<graph::Threads> default_threads(ExecutorKind kind, int subsystems, int available) {
  constexpr std::array teams{1, 2, 4};
  constexpr int kFew = 12;
  std::vector<graph::Threads> list;
  for (int n = 1; n < available; n *= 2) list.emplace_back(n);
  append_once(list, available);
  if (has_two_layers(kind))
    for (const int inner : teams)
      if (subsystems * inner <= std::max(kFew, 2 * available))
        append_once(list, {subsystems, inner});
  return list;
}

void demand_use_of_nested_threads(const Axes& axes) {
  if (std::any_of(axes.executors.begin(), axes.executors.end(), has_two_layers)) return;
  for (const graph::Threads& threads : axes.threads)
    if (threads.inner > 1)
      throw InputError("--threads: " + graph::name_of(threads) +
                       " is of nested teams, but the executors compared have one layer of threads");
}

/// Adds the configurations of one executor on one number of threads.
void append_variants(std::vector<Configuration>& list, Configuration configuration,
                     const Axes& axes) {
  if (!is_openmp(configuration.executor) || configuration.threads.total() == 1) {
    list.push_back(configuration);
    return;
  }
  for (const Wait wait : axes.waits)
    for (const bool bind : axes.binds) {
      configuration.wait = wait;
      configuration.bind = bind;
      list.push_back(configuration);
    }
}

bool is_of_openmp(std::string_view variable) {
  return variable.starts_with("OMP_") || variable.starts_with("GOMP_") ||
         variable.starts_with("KMP_");
}

}  // namespace

std::string_view name_of(Wait wait) {
  switch (wait) {
    case Wait::passive:
      return "passive";
    case Wait::active:
      return "active";
    case Wait::runtime_default:
      break;
  }
  return "default";
}

bool is_openmp(ExecutorKind kind) { return graph::name_of(kind).starts_with("openmp"); }

bool has_two_layers(ExecutorKind kind) { return graph::name_of(kind).starts_with("openmp_scheme"); }

std::string name_of(const Configuration& configuration) {
  std::string name(graph::name_of(configuration.executor));
  if (configuration.executor == ExecutorKind::serial) return name;
  name += ' ' + graph::name_of(configuration.threads);
  if (configuration.wait != Wait::runtime_default)
    name.append(" ").append(name_of(configuration.wait));
  if (configuration.bind) name += " bound";
  return name;
}

std::vector<std::string> environment_of(const Configuration& configuration) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!is_of_openmp(*variable)) variables.emplace_back(*variable);
  if (!is_openmp(configuration.executor)) return variables;
  variables.emplace_back(configuration.bind ? "OMP_PROC_BIND=true" : "OMP_PROC_BIND=false");
  // Runtimes read their own variables first: say the same in each one's words.
  if (configuration.wait == Wait::passive)
    variables.insert(variables.end(),
                     {"OMP_WAIT_POLICY=passive", "GOMP_SPINCOUNT=0", "KMP_BLOCKTIME=0"});
  if (configuration.wait == Wait::active)
    variables.insert(variables.end(), {"OMP_WAIT_POLICY=active", "GOMP_SPINCOUNT=infinity",
                                       "KMP_BLOCKTIME=infinite"});
  return variables;
}

std::vector<Configuration> make_configurations(const Axes& axes, int subsystems, int available) {
  demand_use_of_nested_threads(axes);
  std::vector<Configuration> list;
  for (const Formulation formulation : axes.formulations) {
    list.push_back({.formulation = formulation});
    for (const ExecutorKind executor : axes.executors) {
      if (executor == ExecutorKind::serial) continue;
      for (const graph::Threads threads :
           axes.threads.empty() ? default_threads(executor, subsystems, available) : axes.threads)
        if (threads.inner == 1 || has_two_layers(executor))
          append_variants(list, {formulation, executor, threads}, axes);
    }
  }
  return list;
}

}  // namespace spoke::compare
