#pragma once

// The processors that a thread may run on.

#include <vector>

namespace spoke::graph {

/// Numbers of the processors that the calling thread may run on, ascending. Empty if the system
/// does not say.
std::vector<int> thread_affinity();

/// Has the calling thread, and threads that it makes later, run on these processors, as far as the
/// system allows.
void set_thread_affinity(const std::vector<int>& processors);
/// The same with all that the system allows it.
void set_widest_thread_affinity();

}  // namespace spoke::graph
