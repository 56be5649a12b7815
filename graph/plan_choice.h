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
};

/// Chooses among alternatives that took turns: `samples[0]` are those of the serial one, all have
/// the same number of samples. Each alternative's speedup is the median over the rounds of the
/// ratio within a round, so that what disturbs whole rounds cancels. The largest wins, but serial
/// does unless the gain is `least_gain` or more.
Choice choose_plan(std::span<const Samples> samples, double least_gain = 1.05);

}  // namespace spoke::graph
