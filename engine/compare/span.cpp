#include "engine/compare/span.h"

#include <algorithm>
#include <chrono>

#include "engine/compare/statistics.h"

namespace spoke::compare {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

/// What reading the clock adds to a measured time [s].
double clock_cost() {
  std::vector<double> times(101);
  for (double& time : times) {
    const auto begin = Clock::now();
    time = seconds_between(begin, Clock::now());
  }
  return median(times);
}

}  // namespace

WorkAndSpan calc_work_and_span(const graph::StepGraph& graph, std::span<const double> costs) {
  WorkAndSpan result;
  std::vector<double> ends(costs.size());  // of the costliest path to and with each node
  for (int k = 0; k < graph.node_count(); ++k) {
    const auto node = static_cast<std::size_t>(k);
    double begin = 0.0;
    for (const graph::NodeId before : graph.predecessors({k}))
      begin = std::max(begin, ends[static_cast<std::size_t>(before.index)]);
    ends[node] = begin + costs[node];
    result.work += costs[node];
    result.span = std::max(result.span, ends[node]);
  }
  return result;
}

std::vector<double> measure_node_costs(const graph::StepGraph& graph, int passes) {
  std::vector<std::vector<double>> times(static_cast<std::size_t>(graph.node_count()));
  const double overhead = clock_cost();
  for (int pass = 0; pass < passes; ++pass)
    for (const graph::NodeId node : graph.serial_order()) {
      const auto begin = Clock::now();
      graph.run_node(node);
      const double time = seconds_between(begin, Clock::now());
      times[static_cast<std::size_t>(node.index)].push_back(std::max(0.0, time - overhead));
    }
  std::vector<double> costs;
  for (const auto& of_node : times) costs.push_back(median(of_node));
  return costs;
}

}  // namespace spoke::compare
