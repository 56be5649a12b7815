#pragma once

// What is compared: one way to run a scenario's step, and the matrix of all of them.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation.h"

namespace spoke::compare {

/// How idle threads of an OpenMP runtime wait; read when the runtime starts.
enum class Wait {
  runtime_default,  ///< as the runtime does by default
  passive,          ///< asleep
  active,           ///< spinning
};
/// "default", "passive", "active".
std::string_view name_of(Wait wait);

/// How many times an idle thread of an OpenMP runtime looks for work before it sleeps; read when
/// the runtime starts.
struct Spin {
  static constexpr std::int64_t kInfinite = std::numeric_limits<std::int64_t>::max();
  static constexpr std::int64_t kMost =
      100'000'000'000;  ///< of those that end: a quarter of an hour

  std::optional<std::int64_t> count = {};  ///< none: as Wait says
  bool operator==(const Spin&) const = default;
};
/// "default", "1000", "infinite".
std::string name_of(Spin spin);

struct Configuration {
  Formulation formulation = Formulation::structured;
  ExecutorKind executor = ExecutorKind::serial;
  graph::Threads threads = 1;
  Wait wait = Wait::runtime_default;  ///< of OpenMP executors
  Spin spin = {};                     ///< likewise
  bool bind = false;                  ///< OpenMP threads to processors
};

/// "flow_graph 2", "openmp_scheme2 3x2 active spin 1000 bound": all but the formulation.
std::string name_of(const Configuration& configuration);

/// The whole environment for a process that measures the configuration, as "NAME=value": that of
/// this process without the variables of OpenMP runtimes, and with those the configuration needs.
std::vector<std::string> environment_of(const Configuration& configuration);

/// The values along each axis of the matrix.
struct Axes {
  std::vector<Formulation> formulations{Formulation::structured, Formulation::subsystem};
  std::vector<ExecutorKind> executors{graph::executor_kinds().begin(),
                                      graph::executor_kinds().end()};
  std::vector<graph::Threads> threads = {};  ///< empty: what suits executor, model and machine
  std::vector<Wait> waits = {};  ///< empty: all, but with a spin count the runtime's default
  std::vector<Spin> spins{Spin{}};
  std::vector<bool> binds{false};
};

/// All configurations by formulation, in each the serial one first, as the reference (also if it is
/// not among the executors). Nested threads go to executors that know them; waiting, spinning and
/// binding are varied where an OpenMP executor has more than one thread, but what tells the runtime
/// the same comes once. Throws InputError if a nested number of threads suits none of the
/// executors.
std::vector<Configuration> make_configurations(const Axes& axes, int subsystems, int available);

}  // namespace spoke::compare
