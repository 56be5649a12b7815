#pragma once

// What another thread is worth on this machine now.

namespace spoke::graph {

/// How much work all `threads` do at once, by what one does alone: about `threads` on as many idle
/// processors, less where other programs run or two processors are one core. Runs the same busy
/// loop on one thread and on all of a flow graph's at once, in turns, for about `seconds`; between
/// 0 and `threads`. 1 of one thread. Precondition: threads >= 1.
double measure_capacity(int threads, double seconds = 1e-3);

}  // namespace spoke::graph
