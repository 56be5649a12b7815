#pragma once

// The OpenMP executors of this build, for several questions of the benchmarks.

#include <vector>

#include "graph/executor.h"

namespace spoke::bench {

/// Returns the OpenMP executors of this build. Their threads spin on after a run and disturb
/// others: they are measured behind a pause.
inline std::vector<graph::ExecutorKind> openmp_kinds() {
  using graph::ExecutorKind;
  std::vector<ExecutorKind> kinds;
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (graph::is_openmp(kind)) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace spoke::bench
