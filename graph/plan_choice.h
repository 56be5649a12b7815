#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace spoke::graph {

/// Seconds per run of one alternative, one sample per round.
using Samples = std::vector<double>;

struct Choice {
  std::size_t index = 0;  ///< 0: serial
  double speedup = 1.0;   ///< over serial, of the best that is not serial
  double foreseen = 1.0;  ///< of the same
};

/// The speedup from which a plan is worth its threads. A run of few handovers' length loses most
/// when other programs take a processor, so it must promise more. `handover` in seconds.
double least_gain(double seconds_per_run, double handover);

/// Chooses among alternatives that took turns: `samples[0]` are those of the serial one, all have
/// the same number of samples. Each alternative's speedup is the median over the rounds of the
/// ratio within a round, so that what disturbs whole rounds cancels. Much more than the simulator
/// has foreseen is luck on a busy machine, and counts for no more than 15 % above. The largest
/// wins, but serial does unless the gain is `least` or more. `foreseen`: as many speedups; that of
/// the serial one does not matter.
Choice choose_plan(std::span<const Samples> samples, std::span<const double> foreseen,
                   double least = 1.05);

}  // namespace spoke::graph
