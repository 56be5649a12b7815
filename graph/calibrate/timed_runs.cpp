// Times runs of an executor, and keeps a processor busy for a given time.

#include "graph/calibrate/timed_runs.h"

#include <cassert>
#include <utility>
#include <vector>

#include "graph/calibrate/quantiles.h"
#include "graph/machine/time_stamp.h"

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
  assert(runs > 0);
  executor.run();
  std::vector<double> seconds(static_cast<std::size_t>(runs));
  for (double& taken : seconds) {
    const std::uint64_t begin = time_stamp();
    executor.run();
    taken = seconds_since(begin);
  }
  return lower_quartile(std::move(seconds));
}

}  // namespace spoke::graph
