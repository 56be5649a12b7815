// Widens the affinity of the thread, and sets it back.

#include "graph/execute/unbound_thread.h"

#include "graph/machine/affinity.h"

#ifdef SPOKE_HAS_OPENMP
#include "graph/execute/openmp_runtime.h"
#endif

namespace spoke::graph {

UnboundThread::UnboundThread() {
#ifdef SPOKE_HAS_OPENMP
  const auto binding = openmp_binding();
  if (!binding) return;
  const auto is_whole = [&](const std::vector<int>& processors) {
    return processors.size() == static_cast<std::size_t>(binding->processors);
  };
  const std::vector<int> before = thread_affinity();
  if (before.empty() || is_whole(before)) return;
  // The runtime tells how many processors the process had, but not which. If that is all the system
  // has for it, all are allowed; otherwise they were restricted from outside, and the runtime only
  // tells those it made places of.
  set_widest_thread_affinity();
  if (!is_whole(thread_affinity())) set_thread_affinity(binding->places);
  before_ = before;
#endif
}

UnboundThread::~UnboundThread() {
  if (!before_.empty()) set_thread_affinity(before_);
}

}  // namespace spoke::graph
