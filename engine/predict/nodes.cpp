#include "engine/predict/nodes.h"

#include <algorithm>

#include "engine/compare/statistics.h"

namespace spoke::predict {
namespace {

bool has_levels() {
  const auto kinds = graph::executor_kinds();
  return std::find(kinds.begin(), kinds.end(), ExecutorKind::openmp_levels) != kinds.end();
}

NodeMeasurement mean_of(const std::vector<NodeMeasurement>& measurements) {
  NodeMeasurement mean = measurements.front();
  for (std::size_t k = 1; k < measurements.size(); ++k) {
    const NodeMeasurement& more = measurements[k];
    for (std::size_t node = 0; node < mean.costs.size(); ++node)
      mean.costs[node] += more.costs[node];
    mean.between_runs += more.between_runs;
    mean.runs_per_step += more.runs_per_step;
    mean.run_times.insert(mean.run_times.end(), more.run_times.begin(), more.run_times.end());
  }
  const double share = 1.0 / static_cast<double>(measurements.size());
  for (double& cost : mean.costs) cost *= share;
  mean.between_runs *= share;
  mean.runs_per_step *= share;
  return mean;
}

}  // namespace

std::int64_t choose_steps(Simulation& simulation, double seconds) {
  constexpr double kMostStamps = 8e6;  // 64 MB of them
  constexpr double kFewestWindows = 8.0;
  const std::int64_t window = std::max(simulation.options().window, 1);
  const NodeMeasurement first = simulation.measure_nodes(2 * window);
  const double runs = first.runs_per_step * static_cast<double>(window);
  const double nodes = std::max(1, simulation.run_graph().node_count());
  const double affordable = seconds / (runs * compare::median(first.run_times));
  const double windows = std::clamp(affordable, kFewestWindows,
                                    std::max(kFewestWindows, kMostStamps / (runs * nodes)));
  return window * static_cast<std::int64_t>(windows);
}

int NodeTimer::orders() { return has_levels() ? 2 : 1; }

void NodeTimer::measure(std::int64_t steps) {
  serial_.push_back(simulation_.measure_nodes(steps));
  if (has_levels()) levels_.push_back(simulation_.measure_nodes(steps, graph::NodeOrder::levels));
  steps_ += steps;
}

Nodes NodeTimer::summarise() const {
  Nodes nodes{mean_of(serial_), {}, {}, steps_};
  if (!levels_.empty()) nodes.level_costs = mean_of(levels_).costs;
  const std::vector<double>& times = nodes.mean.run_times;
  const double median = compare::median(times);
  if (median > 0.0)
    nodes.spread = {compare::quantile(times, 0.25) / median,
                    compare::quantile(times, 0.75) / median};
  return nodes;
}

}  // namespace spoke::predict
