// Medians of the costs of nodes over the rounds.

#include "bench/predict/nodes.h"

#include <algorithm>
#include <cassert>

#include "bench/compare/statistics.h"

namespace spoke::predict {
namespace {

/// Returns the median of one quantity over all measurements.
template <class Quantity>
double median_of(const std::vector<NodeMeasurement>& measurements, Quantity quantity) {
  std::vector<double> values(measurements.size());
  std::transform(measurements.begin(), measurements.end(), values.begin(), quantity);
  return compare::median(values);
}

NodeMeasurement medians_of(const std::vector<NodeMeasurement>& measurements) {
  NodeMeasurement medians;
  for (std::size_t node = 0; node < measurements.front().costs.size(); ++node)
    medians.costs.push_back(
        median_of(measurements, [node](const NodeMeasurement& m) { return m.costs[node]; }));
  medians.between_runs =
      median_of(measurements, [](const NodeMeasurement& m) { return m.between_runs; });
  medians.runs_per_step =
      median_of(measurements, [](const NodeMeasurement& m) { return m.runs_per_step; });
  for (const NodeMeasurement& measurement : measurements)
    medians.run_times.insert(medians.run_times.end(), measurement.run_times.begin(),
                             measurement.run_times.end());
  return medians;
}

}  // namespace

std::int64_t choose_steps(Simulation& simulation, double seconds) {
  constexpr double kMostStamps = 8e6;  // 64 MB
  constexpr double kFewestWindows = 8.0;
  const std::int64_t window = std::max(simulation.options().window, 1);
  const NodeMeasurement first = measure_nodes(simulation, 2 * window);
  const double runs = first.runs_per_step * static_cast<double>(window);
  const double nodes = std::max(1, simulation.run_graph().node_count());
  const double affordable = seconds / (runs * compare::median(first.run_times));
  const double windows = std::clamp(affordable, kFewestWindows,
                                    std::max(kFewestWindows, kMostStamps / (runs * nodes)));
  return window * static_cast<std::int64_t>(windows);
}

void NodeTimer::measure(std::int64_t steps) {
  assert(steps > 0);
  rounds_.push_back(measure_nodes(simulation_, steps));
  steps_ += steps;
}

Nodes NodeTimer::summarise() const {
  assert(!rounds_.empty());
  Nodes nodes{medians_of(rounds_), {}, steps_};
  const std::vector<double>& times = nodes.serial.run_times;
  const double median = compare::median(times);
  if (median > 0.0)
    nodes.spread = {compare::quantile(times, 0.25) / median,
                    compare::quantile(times, 0.75) / median};
  return nodes;
}

}  // namespace spoke::predict
