#pragma once

// What the OpenMP runtime makes of its environment. Of builds with OpenMP only.

#include <cstddef>
#include <optional>
#include <vector>

#include "graph/executor.h"

namespace spoke::graph {

/// Where the runtime binds its threads to, as OMP_PROC_BIND, OMP_PLACES and the like say. It also
/// binds the initial thread of the process, when it is loaded or first used.
struct OpenMpBinding {
  int processors = 0;       ///< that the process had before
  std::vector<int> places;  ///< numbers of the processors of all places, each once
};

/// Nothing if it binds no threads. It is asked only if OMP_PROC_BIND, OMP_PLACES,
/// GOMP_CPU_AFFINITY or KMP_AFFINITY is set.
std::optional<OpenMpBinding> openmp_binding();

/// How many of its threads can run at once: available_threads(), at most the processors of all
/// places.
int processors_for_openmp();

/// The stack of a thread by OMP_STACKSIZE, which runtimes read when they are loaded [bytes]; 0: it
/// says none.
std::size_t openmp_stack();

/// Throws InputError unless OMP_NUM_THREADS is one that the runtime survives. To be called before
/// anything asks the runtime, which reads its environment then. Spoke itself does not use it.
void check_openmp_environment();

/// As check_thread_limit(), for a kind of OpenMP.
void check_openmp_limit(ExecutorKind kind, const Threads& threads);

}  // namespace spoke::graph
