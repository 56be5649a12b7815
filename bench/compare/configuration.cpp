// The default numbers of threads, names, and which settings of OpenMP are the same to the runtime.

#include "bench/compare/configuration.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "models/error.h"

namespace spoke::compare {
namespace {

void append_once(std::vector<graph::Threads>& list, graph::Threads threads) {
  if (std::find(list.begin(), list.end(), threads) == list.end()) list.push_back(threads);
}

/// Returns powers of two below the number of available processors, and that number; for nested
/// teams also a thread per subsystem, alone and with small teams, unless that oversubscribes the
/// processors beyond sense.
std::vector<graph::Threads> default_threads(ExecutorKind kind, int subsystems, int available) {
  constexpr std::array teams{1, 2, 4};
  constexpr int kFew = 12;
  std::vector<graph::Threads> list;
  for (int n = 1; n < available; n *= 2) list.emplace_back(n);
  append_once(list, available);
  if (graph::has_nested_teams(kind))
    for (const int inner : teams)
      if (subsystems * inner <= std::max(kFew, 2 * available))
        append_once(list, {subsystems, inner});
  return list;
}

void require_use_of_nested_threads(const Axes& axes) {
  if (std::any_of(axes.executors.begin(), axes.executors.end(), graph::has_nested_teams)) return;
  for (const graph::Threads& threads : axes.threads)
    if (threads.inner > 1)
      throw InputError("--threads: " + graph::name_of(threads) +
                       " is of nested teams, but the executors compared have one layer of threads");
}

/// Returns the wait policies that a spin count is combined with.
std::vector<Wait> waits_with(Spin spin, const Axes& axes) {
  if (!axes.waits.empty()) return axes.waits;
  // A count takes the place of the policies.
  if (spin.count) return {Wait::runtime_default};
  return {Wait::runtime_default, Wait::passive, Wait::active};
}

/// Returns the spin count in force; a policy that the runtime is told implies one.
std::optional<std::int64_t> spin_count_of(const Configuration& configuration) {
  if (configuration.spin.count) return configuration.spin.count;
  if (configuration.wait == Wait::passive) return 0;
  if (configuration.wait == Wait::active) return Spin::kInfinite;
  return std::nullopt;
}

bool waits_alike(const Configuration& a, const Configuration& b) {
  return a.wait == b.wait && spin_count_of(a) == spin_count_of(b);
}

/// Returns the configuration with each way of waiting along the axes, once.
std::vector<Configuration> with_waiting(Configuration configuration, const Axes& axes) {
  std::vector<Configuration> list;
  for (const Spin spin : axes.spins)
    for (const Wait wait : waits_with(spin, axes)) {
      configuration.wait = wait;
      configuration.spin = spin;
      if (std::none_of(list.begin(), list.end(), [&](const Configuration& other) {
            return waits_alike(configuration, other);
          }))
        list.push_back(configuration);
    }
  return list;
}

/// Adds the configurations of one executor on one number of threads.
void append_variants(std::vector<Configuration>& list, Configuration configuration,
                     const Axes& axes) {
  if (!graph::is_openmp(configuration.executor) || configuration.threads.total() == 1) {
    list.push_back(configuration);
    return;
  }
  for (Configuration& waiting : with_waiting(configuration, axes))
    for (const bool bind : axes.binds) {
      waiting.bind = bind;
      list.push_back(waiting);
    }
}

bool is_of_openmp(std::string_view variable) {
  return variable.starts_with("OMP_") || variable.starts_with("GOMP_") ||
         variable.starts_with("KMP_");
}

/// Returns the value of GOMP_SPINCOUNT: libgomp counts looks.
std::string looks_text(std::int64_t count) {
  return count == Spin::kInfinite ? "infinity" : std::to_string(count);
}

/// Returns the value of KMP_BLOCKTIME: libomp looks for a time in whole milliseconds. The duration
/// of a look is libgomp's own estimate.
std::string milliseconds_text(std::int64_t count) {
  constexpr std::int64_t kLooksPerMillisecond = 100'000;
  if (count == Spin::kInfinite) return "infinite";
  return std::to_string((count + kLooksPerMillisecond - 1) / kLooksPerMillisecond);
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

std::string name_of(Spin spin) {
  if (!spin.count) return "default";
  return *spin.count == Spin::kInfinite ? "infinite" : std::to_string(*spin.count);
}

std::string name_of(const Configuration& configuration) {
  std::string name(graph::name_of(configuration.executor));
  if (configuration.executor == ExecutorKind::serial) return name;
  name += ' ' + graph::name_of(configuration.threads);
  if (configuration.wait != Wait::runtime_default)
    name.append(" ").append(name_of(configuration.wait));
  if (configuration.spin.count) name.append(" spin ").append(name_of(configuration.spin));
  if (configuration.bind) name += " bound";
  return name;
}

std::vector<std::string> environment_of(const Configuration& configuration) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!is_of_openmp(*variable)) variables.emplace_back(*variable);
  if (!graph::is_openmp(configuration.executor)) return variables;
  variables.emplace_back(configuration.bind ? "OMP_PROC_BIND=true" : "OMP_PROC_BIND=false");
  if (configuration.wait != Wait::runtime_default)
    variables.push_back("OMP_WAIT_POLICY=" + std::string(name_of(configuration.wait)));
  // Runtimes read their own variables first: say the same in each one's words.
  if (const auto count = spin_count_of(configuration)) {
    variables.push_back("GOMP_SPINCOUNT=" + looks_text(*count));
    variables.push_back("KMP_BLOCKTIME=" + milliseconds_text(*count));
  }
  return variables;
}

std::vector<Configuration> make_configurations(const Axes& axes, int subsystems, int available) {
  require_use_of_nested_threads(axes);
  std::vector<Configuration> list;
  for (const Formulation formulation : axes.formulations) {
    list.push_back({.formulation = formulation});
    for (const ExecutorKind executor : axes.executors) {
      if (executor == ExecutorKind::serial) continue;
      for (const graph::Threads threads :
           axes.threads.empty() ? default_threads(executor, subsystems, available) : axes.threads)
        if (threads.inner == 1 || graph::has_nested_teams(executor))
          append_variants(list, {formulation, executor, threads}, axes);
    }
  }
  return list;
}

}  // namespace spoke::compare
