#include "graph/runtime_costs.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "graph/executor.h"
#include "graph/overheads.h"
#include "graph/time_stamp.h"

namespace spoke::graph {
namespace {

bool has_openmp() {
  const auto kinds = executor_kinds();
  return std::find(kinds.begin(), kinds.end(), ExecutorKind::openmp_levels) != kinds.end();
}

// The lower quartile: what disturbs only adds.
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

// Levels of two empty nodes, each of which waits for both nodes of the level before.
StepGraph make_ladder(int levels) {
  StepGraphBuilder builder;
  std::vector<PartId> before;
  for (int level = 0; level < levels; ++level) {
    std::vector<PartId> parts;
    for (int k = 0; k < 2; ++k) {
      parts.push_back(builder.add_part("part", {}));
      builder.add_node({"rung"}, reads(before), writes(parts.back()), []() noexcept {});
    }
    before = std::move(parts);
  }
  return builder.build();
}

double measure_flow_graph_run(double per_cluster) {
  const StepGraph graph = make_ladder(1);
  const auto executor = make_executor(graph, ExecutorKind::flow_graph, 1);
  return seconds_per_run(*executor, 200) - 2.0 * per_cluster;
}

double measure_barrier(int threads) {
  constexpr int levels = 100;
  const StepGraph graph = make_ladder(levels);
  const auto executor = make_executor(graph, ExecutorKind::openmp_levels, threads);
  return std::clamp(seconds_per_run(*executor, 60) / levels, 1e-9, 5e-6);
}

RuntimeCosts measure() {
  RuntimeCosts costs;
  costs.flow_graph = flow_graph_overheads();
  costs.flow_graph_run =
      std::clamp(measure_flow_graph_run(costs.flow_graph.per_cluster), 0.05e-6, 5e-6);
  if (has_openmp()) {
    costs.barrier_alone = measure_barrier(1);
    costs.barrier = measure_barrier(2);
  }
  return costs;
}

}  // namespace

const RuntimeCosts& runtime_costs() {
  static const RuntimeCosts costs = measure();
  return costs;
}

RuntimeCosts scaled(const RuntimeCosts& costs, double factor) {
  RuntimeCosts result = costs;
  for (double* cost :
       {&result.flow_graph.per_node, &result.flow_graph.per_cluster, &result.flow_graph.handover,
        &result.flow_graph_run, &result.barrier, &result.barrier_alone})
    *cost *= factor;
  return result;
}

}  // namespace spoke::graph
