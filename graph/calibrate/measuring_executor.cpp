// Chooses the runs with time stamps, and scales the nodes' times to the runs without.

#include "graph/calibrate/measuring_executor.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>

#include "graph/calibrate/quantiles.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {
namespace {

double seconds_of(std::uint64_t ticks) {
  const TimeStampScale& scale = time_stamp_scale();
  return std::max(0.0, static_cast<double>(ticks) * scale.seconds_per_tick - scale.cost);
}

// Follows the Thue-Morse sequence: half of the runs, and half of the runs of any small period, such
// as the passes of a step.
bool has_stamps(int run) { return std::popcount(static_cast<unsigned>(run)) % 2 == 0; }

// Returns the median over stretches of their means: dear runs count as cheap ones do, but not the
// stretches that another program disturbed. With less than two whole stretches it is the mean.
double robust_mean(const std::vector<double>& times) {
  constexpr double stretch = 20e-3;  // s
  const double seconds = std::accumulate(times.begin(), times.end(), 0.0);
  const auto count =
      std::clamp<std::size_t>(static_cast<std::size_t>(seconds / stretch), 1, times.size());
  std::vector<double> means(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto begin = times.begin() + static_cast<std::ptrdiff_t>(k * times.size() / count);
    const auto end = times.begin() + static_cast<std::ptrdiff_t>((k + 1) * times.size() / count);
    means[k] = std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
  }
  return median(std::move(means));
}

std::vector<double> in_seconds(const std::vector<std::uint64_t>& ticks) {
  std::vector<double> times(ticks.size());
  std::transform(ticks.begin(), ticks.end(), times.begin(),
                 [](std::uint64_t count) { return seconds_of(count); });
  return times;
}

}  // namespace

void MeasuringExecutor::run() {
  if (has_stamps(runs())) return costs_.run();
  const std::uint64_t begin = time_stamp();
  for (const NodeId node : graph_.serial_order()) graph_.run_node(node);
  plain_ticks_.push_back(time_stamp() - begin);
}

void MeasuringExecutor::run_while(const std::function<bool()>& more) {
  bool again = true;
  while (again) {
    run();
    const std::uint64_t begin = time_stamp();
    again = more();
    ticks_between_.push_back(time_stamp() - begin);
  }
}

// A stamp costs less between nodes, whose instructions overlap with it, than it does alone: a
// deficit of the sum was taken from all nodes alike, and an excess is in proportion to their times.
std::vector<double> MeasuringExecutor::node_costs() const {
  assert(runs() > 0);
  std::vector<double> costs = costs_.costs();
  if (plain_ticks_.empty() || costs.empty()) return costs;
  const double stamped = std::accumulate(costs.begin(), costs.end(), 0.0);
  const double plain = robust_mean(run_times());
  const double missing = (plain - stamped) / static_cast<double>(costs.size());
  for (double& cost : costs) cost = missing > 0.0 ? cost + missing : cost * plain / stamped;
  return costs;
}

std::vector<double> MeasuringExecutor::run_times() const { return in_seconds(plain_ticks_); }

double MeasuringExecutor::between_runs() const {
  return ticks_between_.empty() ? 0.0 : robust_mean(in_seconds(ticks_between_));
}

}  // namespace spoke::graph
