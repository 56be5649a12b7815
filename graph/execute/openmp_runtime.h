#pragma once

// The OpenMP runtime's view of its environment. Only in builds with OpenMP.

#include <cstddef>
#include <optional>
#include <vector>

#include "graph/executor.h"

namespace spoke::graph {

/// The processors to which the runtime binds its threads, as OMP_PROC_BIND, OMP_PLACES and the like
/// say. It also binds the initial thread of the process, when it is loaded or first used.
struct OpenMpBinding {
  int processors = 0;       ///< number of processors that the process had before
  std::vector<int> places;  ///< numbers of the processors of all places, each once
};

/// Returns the binding; none if it binds no threads. The runtime is queried only if OMP_PROC_BIND,
/// OMP_PLACES, GOMP_CPU_AFFINITY or KMP_AFFINITY is set.
std::optional<OpenMpBinding> openmp_binding();

/// Returns how many of its threads can run at once: available_threads(), at most the processors of
/// all places.
int processors_for_openmp();

/// Returns the stack of a thread by OMP_STACKSIZE [bytes], which runtimes read when they are
/// loaded; 0: not set.
std::size_t openmp_stack();

/// Throws InputError unless the runtime survives OMP_NUM_THREADS. To be called before anything
/// queries the runtime, which reads its environment then. Spoke itself does not use it.
void check_openmp_environment();

/// Checks like check_thread_limit(), for a kind of OpenMP.
void check_openmp_limit(ExecutorKind kind, const Threads& threads);

}  // namespace spoke::graph
