// Measures clusters, handovers and barriers on calibration graphs.

#include "graph/calibrate/runtime_costs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "graph/calibrate/calibration_graphs.h"
#include "graph/calibrate/quantiles.h"
#include "graph/calibrate/timed_runs.h"
#include "graph/calibrate/transfer_costs.h"
#include "graph/execute/executor_kinds.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {
namespace {

constexpr int kPlaces = 16;        // in memory, of what is transferred
constexpr double kTime = 15e-3;    // s, of one quantity
constexpr double kPatience = 0.1;  // s; a sleeping thread takes milliseconds to join, on a virtual
                                   // machine tens of them

// What one thread takes for a cluster of forks and joins of empty nodes [s], which cost more than
// links of a chain. Where in memory they lie makes some 10 %: the mean of several places.
double seconds_per_cluster(const StepGraph& graph) {
  constexpr int places = 5;
  constexpr double time = 1e-3;                      // s, of a place
  std::vector<std::unique_ptr<Executor>> executors;  // all live, so that each has its own place
  double sum = 0.0;
  for (int k = 0; k < places; ++k) {
    executors.push_back(make_flow_graph_executor(graph, plan_of_single_nodes(graph), 1));
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint64_t begin = time_stamp(); seconds_since(begin) < time;)
      least = std::min(least, seconds_per_run(*executors.back(), 8));
    sum += least;
  }
  return sum / places / graph.node_count();
}

// The more branches a fork has, the more clusters its thread spawns: all but one of each.
void measure_clusters(Overheads& overheads) {
  constexpr int nodes = 1000, few = 2, many = 16;
  const auto seconds_and_spawned = [](int branches) {
    const int forks = nodes / (1 + branches);
    const StepGraph graph = make_fork_joins(forks, 0.0, branches);
    return std::pair(seconds_per_cluster(graph),
                     static_cast<double>(forks * (branches - 1)) / graph.node_count());
  };
  const auto [seconds_of_few, spawned_of_few] = seconds_and_spawned(few);
  const auto [seconds_of_many, spawned_of_many] = seconds_and_spawned(many);
  overheads.spawn = std::clamp(
      (seconds_of_many - seconds_of_few) / (spawned_of_many - spawned_of_few), 0.0, 0.2e-6);
  overheads.per_cluster =
      std::clamp(seconds_of_few - spawned_of_few * overheads.spawn, 10e-9, 1e-6);
}

// Of fork-joins whose two nodes are so long busy, on two threads [s].
double seconds_of_fork_joins(int count, double busy) {
  const StepGraph graph = make_fork_joins(count, busy);
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 2);
  const double alone = 2 * count * busy;
  double least = seconds_per_run(*executor, 50);
  for (const std::uint64_t begin = time_stamp();
       seconds_since(begin) < (least < 0.9 * alone ? kTime : kPatience);)
    least = std::min(least, seconds_per_run(*executor, 50));
  return least;
}

// Each fork-join hands over once: so much longer are runs that have many of them.
double measure_handover(double per_cluster) {
  constexpr int count = 8;
  constexpr double busy = 3e-6;  // s
  const double each =
      (seconds_of_fork_joins(count, busy) - seconds_of_fork_joins(1, busy)) / (count - 1);
  return each - busy - 2.0 * per_cluster;
}

#ifdef SPOKE_HAS_OPENMP
double measure_barrier() {
  constexpr int levels = 100;
  const StepGraph graph = make_ladder(levels);
  const auto executor = make_openmp_levels_executor(graph, 2);
  return seconds_per_run(*executor, 60) / levels;
}

// One thread has no barriers within a run: two stand between one and the next.
double measure_barrier_alone() {
  constexpr int runs = 400;
  const StepGraph graph = make_ladder(1);
  const auto executor = make_openmp_levels_executor(graph, 1);
  double least = 1.0;  // s
  for (int k = 0; k < 8; ++k) {
    int left = runs;
    const std::uint64_t begin = time_stamp();
    executor->run_while([&left] { return --left > 0; });
    least = std::min(least, seconds_since(begin));
  }
  return least / runs / 2.0;
}
#endif

auto all_costs(RuntimeCosts& costs) {
  return std::array{&costs.flow_graph.per_node,
                    &costs.flow_graph.per_cluster,
                    &costs.flow_graph.spawn,
                    &costs.flow_graph.handover,
                    &costs.barrier,
                    &costs.barrier_alone,
                    &costs.transfer.latency,
                    &costs.transfer.per_byte};
}

}  // namespace

RuntimeCosts measure_runtime_costs() {
  RuntimeCosts costs;
  measure_clusters(costs.flow_graph);
  costs.flow_graph.handover =
      std::clamp(measure_handover(costs.flow_graph.per_cluster), 0.1e-6, 5e-6);
  costs.transfer = measure_transfer(kPlaces, kTime);
#ifdef SPOKE_HAS_OPENMP
  costs.barrier_alone = std::clamp(measure_barrier_alone(), 1e-9, 5e-6);
  costs.barrier = std::clamp(measure_barrier(), 1e-9, 5e-6);
#endif
  return costs;
}

RuntimeCosts median(std::vector<RuntimeCosts> measured) {
  assert(!measured.empty());
  RuntimeCosts result;
  const auto costs = all_costs(result);
  std::vector<double> values(measured.size());
  for (std::size_t cost = 0; cost < costs.size(); ++cost) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = *all_costs(measured[k])[cost];
    *costs[cost] = median(values);
  }
  return result;
}

}  // namespace spoke::graph
