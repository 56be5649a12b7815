#include "graph/timed_runs.h"

#include <algorithm>
#include <vector>

#include "graph/time_stamp.h"

namespace spoke::graph {

double seconds_since(std::uint64_t begin) {
  return static_cast<double>(time_stamp() - begin) * time_stamp_scale().seconds_per_tick;
}

void be_busy(double seconds) noexcept {
  const std::uint64_t begin = time_stamp();
  while (seconds_since(begin) < seconds) {
  }
}

double seconds_per_run(Executor& executor, int runs) {
  executor.run();
  std::vector<std::uint64_t> ticks(static_cast<std::size_t>(runs));
  for (std::uint64_t& tick : ticks) {
    const std::uint64_t begin = time_stamp();
    executor.run();
    tick = time_stamp() - begin;
  }
  const auto quartile = ticks.begin() + runs / 4;
  std::nth_element(ticks.begin(), quartile, ticks.end());
  return static_cast<double>(*quartile) * time_stamp_scale().seconds_per_tick;
}

}  // namespace spoke::graph
