#include "engine/predict/nodes.h"

#include <algorithm>

#include "engine/compare/statistics.h"

namespace spoke::predict {

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

Nodes summarise(const std::vector<NodeMeasurement>& measurements, std::int64_t steps) {
  Nodes nodes{measurements.front(), {}, steps * static_cast<std::int64_t>(measurements.size())};
  NodeMeasurement& mean = nodes.mean;
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
  const double median = compare::median(mean.run_times);
  if (median > 0.0)
    nodes.spread = {compare::quantile(mean.run_times, 0.25) / median,
                    compare::quantile(mean.run_times, 0.75) / median};
  return nodes;
}

}  // namespace spoke::predict
