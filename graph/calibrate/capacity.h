#pragma once

// Measures what another thread is worth on this machine now.

namespace spoke::graph {

/// Returns how much work all `threads` do at once, relative to one alone: about `threads` on as
/// many idle processors, less where other programs run or two processors are one core. Runs the
/// same busy loop on one thread and on all of a flow graph's at once, in turns, for about
/// `seconds`; the result is between 0 and `threads`, and 1 for one thread. Precondition: threads >=
/// 1.
double measure_capacity(int threads, double seconds = 1e-3);

}  // namespace spoke::graph
