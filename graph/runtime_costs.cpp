#include "graph/runtime_costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <thread>
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

double seconds_since(std::uint64_t begin) {
  return static_cast<double>(time_stamp() - begin) * time_stamp_scale().seconds_per_tick;
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

// A node that changes data of its own, and how long it took where. The data lie in pieces of four
// cache lines, as the parts of a step do: a processor that fetches ahead gains little.
struct Toucher {
  static constexpr std::size_t kPieces = 16, kPiece = 32, kStride = 160;  // doubles
  std::array<double, kPieces * kStride> data{};
  double seconds = 0.0;
  std::thread::id thread;

  void touch() noexcept {
    const std::uint64_t begin = time_stamp();
    for (std::size_t piece = 0; piece < kPieces; ++piece) {
      for (std::size_t k = 0; k < kPiece; ++k) data[7 * piece % kPieces * kStride + k] += 1.0;
    }
    seconds = seconds_since(begin);
    thread = std::this_thread::get_id();
  }
  // Long enough that another thread comes for one of two.
  void touch_and_wait() noexcept {
    const std::uint64_t begin = time_stamp();
    touch();
    while (seconds_since(begin) < 10e-6) {
    }
  }
};

// One thread changes the data of two nodes, which then run: on that thread and on another.
double measure_transfer() {
  constexpr double time = 30e-3;  // s
  const auto touchers = std::make_unique<std::array<Toucher, 2>>();
  Toucher& a = touchers->front();  // Clang 14 captures no structured bindings
  Toucher& b = touchers->back();
  StepGraphBuilder builder;
  const PartId root = builder.add_part("root", {});
  builder.add_node({"both"}, {}, writes(root), [&]() noexcept {
    a.touch();
    b.touch();
  });
  for (Toucher& toucher : *touchers)
    builder.add_node({"one"}, reads(root), {}, [&]() noexcept { toucher.touch_and_wait(); });
  const StepGraph graph = builder.build();
  const auto executor = make_executor(graph, ExecutorKind::flow_graph, 2);
  std::vector<double> extra;
  for (const std::uint64_t begin = time_stamp(); seconds_since(begin) < time;) {
    executor->run();
    if (a.thread != b.thread) extra.push_back(std::abs(a.seconds - b.seconds));
  }
  if (extra.empty()) return 0.0;
  const auto middle = extra.begin() + static_cast<std::ptrdiff_t>(extra.size() / 2);
  std::nth_element(extra.begin(), middle, extra.end());
  return *middle / static_cast<double>(Toucher::kPieces * Toucher::kPiece * sizeof(double));
}

RuntimeCosts measure() {
  RuntimeCosts costs;
  costs.flow_graph = flow_graph_overheads();
  costs.flow_graph_run =
      std::clamp(measure_flow_graph_run(costs.flow_graph.per_cluster), 0.05e-6, 5e-6);
  costs.per_byte = std::clamp(measure_transfer(), 0.0, 2e-9);
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
        &result.flow_graph_run, &result.barrier, &result.barrier_alone, &result.per_byte})
    *cost *= factor;
  return result;
}

}  // namespace spoke::graph
