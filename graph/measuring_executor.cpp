#include "graph/measuring_executor.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "graph/time_stamp.h"

namespace spoke::graph {
namespace {

double seconds_of(std::uint64_t ticks) {
  const TimeStampScale& scale = time_stamp_scale();
  return std::max(0.0, static_cast<double>(ticks) * scale.seconds_per_tick - scale.cost);
}

// The Thue-Morse sequence: half of the runs, and half of the runs of any small period, such as the
// passes of a step.
bool has_stamps(int run) { return std::popcount(static_cast<unsigned>(run)) % 2 == 0; }

// Without the dearest twentieth.
double robust_mean(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.resize((19 * values.size() + 19) / 20);
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

MeasuringExecutor::MeasuringExecutor(const StepGraph& graph) : graph_(graph), costs_(graph) {}

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

// A stamp costs less between nodes, whose instructions overlap with it, than it does alone: what is
// missing in the sum was taken from all nodes alike. What is too much is in proportion.
std::vector<double> MeasuringExecutor::node_costs() const {
  std::vector<double> costs = costs_.costs();
  if (plain_ticks_.empty() || costs.empty()) return costs;
  const double stamped = std::accumulate(costs.begin(), costs.end(), 0.0);
  const double plain = robust_mean(run_times());
  const double missing = (plain - stamped) / static_cast<double>(costs.size());
  for (double& cost : costs) cost = missing > 0.0 ? cost + missing : cost * plain / stamped;
  return costs;
}

std::vector<double> MeasuringExecutor::run_times() const {
  std::vector<double> times(plain_ticks_.size());
  std::transform(plain_ticks_.begin(), plain_ticks_.end(), times.begin(), seconds_of);
  return times;
}

double MeasuringExecutor::between_runs() const {
  if (ticks_between_.empty()) return 0.0;
  std::vector<std::uint64_t> sorted = ticks_between_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return seconds_of(*middle);
}

}  // namespace spoke::graph
