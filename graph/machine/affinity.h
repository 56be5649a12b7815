#pragma once

// Reads and sets the processors that a thread may run on.

#include <vector>

namespace spoke::graph {

/// Returns the numbers of the processors that the calling thread may run on, ascending. Empty if
/// the system does not say.
std::vector<int> thread_affinity();

/// Lets the calling thread, and threads that it makes later, run only on these processors, as far
/// as the system allows.
void set_thread_affinity(const std::vector<int>& processors);
/// Lets them run on all processors that the system allows.
void set_widest_thread_affinity();

}  // namespace spoke::graph
