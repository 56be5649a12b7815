#include "graph/runtime_costs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "graph/calibration_graphs.h"
#include "graph/counting_costs.h"
#include "graph/executor_kinds.h"
#include "graph/overheads.h"
#include "graph/quantiles.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"
#include "graph/transfer_costs.h"

namespace spoke::graph {
namespace {

// How much time measuring takes.
struct Effort {
  double time;  // of one quantity [s]
  int places;   // in memory
};

// `alone`: what one of several threads takes at least. A sleeping thread takes milliseconds to
// join, on a virtual machine tens of them.
double least_seconds_per_run(Executor& executor, double time, double alone) {
  constexpr double patience = 0.1;  // s
  double least = seconds_per_run(executor, 50);
  for (const std::uint64_t begin = time_stamp();
       seconds_since(begin) < (least < 0.9 * alone ? time : patience);)
    least = std::min(least, seconds_per_run(executor, 50));
  return least;
}

double measure_flow_graph(const StepGraph& graph, double time, int threads, double alone = 1.0) {
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), threads);
  return least_seconds_per_run(*executor, time, alone);
}

// Of two nodes, which both are kept when it starts.
double measure_flow_graph_run(double time, const Overheads& overheads) {
  return measure_flow_graph(make_ladder(1), time, 1) -
         2.0 * (overheads.per_cluster + overheads.keeping);
}

// Fork-joins of so many clusters, of which a third is kept.
double measure_among_many(const Overheads& overheads) {
  const StepGraph graph = make_fork_joins(kManyClusters / 3, 0.0);
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 1);
  return seconds_per_run(*executor, 12) / graph.node_count() - overheads.per_cluster -
         overheads.keeping / 3.0;
}

// Fork-joins, of which each hands over once, in runs that have one of them and many.
void measure_among_threads(const Effort& effort, RuntimeCosts& costs) {
  constexpr int count = 8;
  constexpr double busy = 3e-6;  // s
  const auto seconds = [&](int fork_joins) {
    return measure_flow_graph(make_fork_joins(fork_joins, busy), effort.time, 2,
                              2 * fork_joins * busy);
  };
  const double one = seconds(1);
  const double each = (seconds(count) - one) / (count - 1);
  const double cluster = costs.flow_graph.per_cluster;
  costs.flow_graph_run_among_threads = std::clamp(one - each - cluster, 0.05e-6, 5e-6);
  const double handover = each - busy - 2.0 * cluster;
  const CountingCosts counting = measure_counting(effort.places);
  costs.flow_graph.contention = counting.wait;
  costs.flow_graph.counting = counting.service;
  costs.flow_graph.handover = std::clamp(handover - counting.wait, 0.1e-6, 5e-6);
}

double measure_barrier() {
  constexpr int levels = 100;
  const StepGraph graph = make_ladder(levels);
  const auto executor = make_executor(graph, ExecutorKind::openmp_levels, 2);
  return seconds_per_run(*executor, 60) / levels;
}

// One thread has no barriers within a run: two stand between one and the next.
double measure_barrier_alone() {
  constexpr int runs = 400;
  const StepGraph graph = make_ladder(1);
  const auto executor = make_executor(graph, ExecutorKind::openmp_levels, 1);
  double least = 1.0;  // s
  for (int k = 0; k < 8; ++k) {
    int left = runs;
    const std::uint64_t begin = time_stamp();
    executor->run_while([&left] { return --left > 0; });
    least = std::min(least, seconds_since(begin));
  }
  return least / runs / 2.0;
}

auto all_costs(RuntimeCosts& costs) {
  return std::array{&costs.flow_graph.per_node,
                    &costs.flow_graph.per_cluster,
                    &costs.flow_graph.handover,
                    &costs.flow_graph.contention,
                    &costs.flow_graph.counting,
                    &costs.flow_graph.keeping,
                    &costs.flow_graph.among_many,
                    &costs.flow_graph_run,
                    &costs.flow_graph_run_among_threads,
                    &costs.barrier,
                    &costs.barrier_alone,
                    &costs.transfer.latency,
                    &costs.transfer.per_byte};
}

RuntimeCosts measure_flow_graph_costs(const Overheads& overheads, const Effort& effort) {
  RuntimeCosts costs;
  costs.flow_graph = overheads;
  costs.flow_graph_run =
      std::clamp(measure_flow_graph_run(effort.time, costs.flow_graph), 0.05e-6, 5e-6);
  measure_among_threads(effort, costs);
  costs.transfer = measure_transfer(effort.places, effort.time);
  return costs;
}

}  // namespace

RuntimeCosts measure_runtime_costs() {
  RuntimeCosts costs = measure_flow_graph_costs(measure_flow_graph_overheads(), {15e-3, 16});
  costs.flow_graph.among_many = std::clamp(measure_among_many(costs.flow_graph), 0.0, 0.2e-6);
  if (has_executor(ExecutorKind::openmp_levels)) {
    costs.barrier_alone = std::clamp(measure_barrier_alone(), 1e-9, 5e-6);
    costs.barrier = std::clamp(measure_barrier(), 1e-9, 5e-6);
  }
  return costs;
}

const RuntimeCosts& flow_graph_costs() {
  static const RuntimeCosts costs = measure_flow_graph_costs(flow_graph_overheads(), {1e-3, 3});
  return costs;
}

RuntimeCosts median(std::vector<RuntimeCosts> measured) {
  RuntimeCosts result;
  const auto costs = all_costs(result);
  std::vector<double> values(measured.size());
  for (std::size_t cost = 0; cost < costs.size(); ++cost) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = *all_costs(measured[k])[cost];
    *costs[cost] = median(values);
  }
  return result;
}

RuntimeCosts scaled(const RuntimeCosts& costs, double factor) {
  RuntimeCosts result = costs;
  for (double* cost : all_costs(result)) *cost *= factor;
  return result;
}

}  // namespace spoke::graph
