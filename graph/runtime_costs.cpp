#include "graph/runtime_costs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "graph/calibration_graphs.h"
#include "graph/counting_costs.h"
#include "graph/executor_kinds.h"
#include "graph/overheads.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

// How much time measuring takes.
struct Effort {
  double time;  // of one quantity [s]
  int places;   // of counting, in memory
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

double measure_flow_graph_run(double time, double per_cluster) {
  return measure_flow_graph(make_ladder(1), time, 1) - 2.0 * per_cluster;
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
  const CountingCosts counting =
      measure_counting(effort.places, costs.flow_graph_run_among_threads + handover);
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

// A node that changes data of its own, and how long it took where. The data lie in pieces of four
// cache lines, as the parts of a step do, and where a piece lies is read from the one before: what
// a real node does with one part needs results of another, so that a processor cannot fetch all of
// them at once.
struct Toucher {
  static constexpr std::size_t kPieces = 16, kPiece = 32, kStride = 160;  // doubles
  std::array<double, kPieces * kStride> data{};
  std::size_t pieces = kPieces;
  double seconds = 0.0;
  std::thread::id thread;

  void touch() noexcept {
    const std::uint64_t begin = time_stamp();
    std::size_t displaced = 0;  // always, but only the data tell
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      double* const first = &data[7 * piece % kPieces * kStride + displaced];
      for (std::size_t k = 1; k < kPiece; ++k) first[k] += 1.0;
      displaced = static_cast<std::size_t>(first[0]);
    }
    std::atomic_thread_fence(std::memory_order_seq_cst);  // what is under way arrives
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

// One thread changes the data of two nodes, which then run: on that thread and on another, which
// takes that much longer [s].
double measure_moved(double time, std::size_t pieces) {
  const auto touchers = std::make_unique<std::array<Toucher, 2>>();
  Toucher& a = touchers->front();  // Clang 14 captures no structured bindings
  Toucher& b = touchers->back();
  a.pieces = b.pieces = pieces;
  std::thread::id root_thread;
  StepGraphBuilder builder;
  const PartId root = builder.add_part("root", {});
  builder.add_node({"both"}, {}, writes(root), [&]() noexcept {
    a.touch();
    b.touch();
    root_thread = a.thread;
  });
  for (Toucher& toucher : *touchers)
    builder.add_node({"one"}, reads(root), {}, [&]() noexcept { toucher.touch_and_wait(); });
  const StepGraph graph = builder.build();
  const auto executor = make_executor(graph, ExecutorKind::flow_graph, 2);
  std::vector<double> extra;
  for (const std::uint64_t begin = time_stamp(); seconds_since(begin) < time;) {
    executor->run();
    if (a.thread == b.thread) continue;
    extra.push_back(a.thread == root_thread ? b.seconds - a.seconds : a.seconds - b.seconds);
  }
  if (extra.empty()) return 0.0;
  const auto middle = extra.begin() + static_cast<std::ptrdiff_t>(extra.size() / 2);
  std::nth_element(extra.begin(), middle, extra.end());
  return *middle;
}

Transfer measure_transfer(double time) {
  constexpr auto bytes = static_cast<double>(Toucher::kPiece * sizeof(double));  // of a piece
  const double one = measure_moved(time, 1);
  const double all = measure_moved(time, Toucher::kPieces);
  const double per_piece = std::max(0.0, (all - one) / (Toucher::kPieces - 1));
  return {std::clamp(one - per_piece, 0.0, 1e-6), std::min(per_piece / bytes, 4e-9)};
}

auto all_costs(RuntimeCosts& costs) {
  return std::array{&costs.flow_graph.per_node,
                    &costs.flow_graph.per_cluster,
                    &costs.flow_graph.handover,
                    &costs.flow_graph.contention,
                    &costs.flow_graph.counting,
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
      std::clamp(measure_flow_graph_run(effort.time, costs.flow_graph.per_cluster), 0.05e-6, 5e-6);
  measure_among_threads(effort, costs);
  costs.transfer = measure_transfer(effort.time);
  return costs;
}

}  // namespace

RuntimeCosts measure_runtime_costs() {
  RuntimeCosts costs = measure_flow_graph_costs(measure_flow_graph_overheads(), {15e-3, 16});
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
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    *costs[cost] = *middle;
  }
  return result;
}

RuntimeCosts scaled(const RuntimeCosts& costs, double factor) {
  RuntimeCosts result = costs;
  for (double* cost : all_costs(result)) *cost *= factor;
  return result;
}

}  // namespace spoke::graph
