#pragma once

// Configurations to compare: one way to run a scenario's step, and the matrix of all of them.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation.h"

namespace spoke::compare {

/// Ways in which idle threads of an OpenMP runtime wait; the runtime reads its setting when it
/// starts.
enum class Wait {
  runtime_default,  ///< as the runtime does by default
  passive,          ///< asleep
  active,           ///< spinning
};
/// Returns "default", "passive" or "active".
std::string_view name_of(Wait wait);

/// Number of times that an idle thread of an OpenMP runtime looks for work before it sleeps; the
/// runtime reads it when it starts.
struct Spin {
  static constexpr std::int64_t kInfinite = std::numeric_limits<std::int64_t>::max();
  static constexpr std::int64_t kMost =
      100'000'000'000;  ///< largest finite count: a quarter of an hour

  std::optional<std::int64_t> count = {};  ///< none: as Wait says
  bool operator==(const Spin&) const = default;
};
/// Returns "default", "1000" or "infinite".
std::string name_of(Spin spin);

struct Configuration {
  Formulation formulation = Formulation::structured;
  ExecutorKind executor = ExecutorKind::serial;
  graph::Threads threads = 1;
  Wait wait = Wait::runtime_default;  ///< OpenMP executors alone
  Spin spin = {};                     ///< OpenMP executors alone
  bool bind = false;                  ///< binds OpenMP threads to processors
};

/// Returns all but the formulation: "flow_graph 2", "openmp_scheme2 3x2 active spin 1000 bound".
std::string name_of(const Configuration& configuration);

/// Returns the whole environment of a process that measures the configuration, as "NAME=value":
/// this process's, with the variables of OpenMP runtimes replaced by those that the configuration
/// needs.
std::vector<std::string> environment_of(const Configuration& configuration);

/// The values along each axis of the matrix.
struct Axes {
  std::vector<Formulation> formulations{Formulation::structured, Formulation::subsystem};
  std::vector<ExecutorKind> executors{graph::executor_kinds().begin(),
                                      graph::executor_kinds().end()};
  std::vector<graph::Threads> threads = {};  ///< empty: by executor, model and machine
  std::vector<Wait> waits = {};  ///< empty: all, but with a spin count the runtime's default
  std::vector<Spin> spins{Spin{}};
  std::vector<bool> binds{false};
};

/// Returns all configurations by formulation, in each the serial one first, as the reference (even
/// if it is not among the executors). Nested threads go to executors that know them; waiting,
/// spinning and binding are varied where an OpenMP executor has more than one thread, but settings
/// that are equal to the runtime come once. Throws InputError if a nested number of threads suits
/// none of the executors.
std::vector<Configuration> make_configurations(const Axes& axes, int subsystems, int available);

}  // namespace spoke::compare
