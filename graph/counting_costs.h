#pragma once

namespace spoke::graph {

/// oneTBB counts the clusters of a flow graph that are under way at one place. What that costs on
/// this machine where two processors take turns [s].
struct CountingCosts {
  double wait = 0.0;     ///< for a processor when another counted last: the counter comes to it
  double service = 0.0;  ///< from one such start to the next, when both have nothing else to do
};

/// Measured at so many places in memory, some 6 ms each; none where this process has one processor,
/// or gets no other.
CountingCosts measure_counting(int places);

}  // namespace spoke::graph
