#pragma once

// Frees a thread of the processor that OpenMP has bound it to.

#include <vector>

namespace spoke::graph {

/// While it lives, the calling thread, and threads that it starts, may run on all processors that
/// the process had before the OpenMP runtime bound its initial thread to a place (OMP_PROC_BIND,
/// OMP_PLACES and the like). Does nothing if the runtime binds no threads, or the build is without
/// OpenMP.
class UnboundThread {
 public:
  UnboundThread();
  /// Binds the calling thread as it was before.
  ~UnboundThread();
  UnboundThread(const UnboundThread&) = delete;
  UnboundThread& operator=(const UnboundThread&) = delete;

 private:
  std::vector<int> before_;  // processors before; none: nothing was changed
};

}  // namespace spoke::graph
