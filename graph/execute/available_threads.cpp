// Counts processors by affinity, control groups and OpenMP's binding.

#include "graph/execute/available_threads.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

#include "graph/executor.h"
#include "graph/machine/affinity.h"
#include "graph/machine/cgroup_processors.h"

#ifdef SPOKE_HAS_OPENMP
#include "graph/execute/openmp_runtime.h"
#endif

namespace spoke::graph {

// The OpenMP runtime may have bound the calling thread to one processor of those that the process
// started with.
int processors_of_process() {
#ifdef SPOKE_HAS_OPENMP
  if (const auto binding = openmp_binding()) return binding->processors;
#endif
  const std::size_t count = thread_affinity().size();
  return count > 0 ? static_cast<int>(count)
                   : static_cast<int>(std::thread::hardware_concurrency());
}

int available_threads() {
  int threads = processors_of_process();
  std::ifstream membership("/proc/self/cgroup");
  if (const auto limit = cgroup_processors(membership, "/sys/fs/cgroup")) {
    threads = static_cast<int>(std::min<double>(threads, std::ceil(*limit)));
  }
  return std::clamp(threads, 1, kMostThreads);
}

}  // namespace spoke::graph
