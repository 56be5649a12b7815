#include "graph/runtime_costs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "graph/executor_kinds.h"
#include "graph/overheads.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

bool has_openmp() {
  const auto kinds = executor_kinds();
  return std::find(kinds.begin(), kinds.end(), ExecutorKind::openmp_levels) != kinds.end();
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

// Levels of short nodes, each of which waits for two of the level before: both threads start nodes
// all the time, and each for the other.
class Weave {
 public:
  Weave() : graph_(make_graph()), plan_(plan_of_single_nodes(graph_)) {}

  double measure(int threads) const {
    const auto executor = make_flow_graph_executor(graph_, plan_, threads);
    const double seconds = seconds_per_run(*executor, 600);
    return std::min(seconds, seconds_per_run(*executor, 600));  // a thread may join late
  }
  double simulate(double node, double per_cluster, double handover) const {
    const std::vector<double> costs(static_cast<std::size_t>(graph_.node_count()), node);
    return simulate_work_stealing(plan_, costs, 2, {0.0, per_cluster, handover}).makespan;
  }
  double nodes() const { return graph_.node_count(); }

 private:
  static StepGraph make_graph() {
    constexpr std::size_t width = 8, levels = 24;
    StepGraphBuilder builder;
    std::vector<PartId> before;
    for (std::size_t level = 0; level < levels; ++level) {
      std::vector<PartId> parts;
      for (std::size_t k = 0; k < width; ++k) {
        std::vector<PartId> needed;
        if (level > 0) needed = {before[k], before[(k + 1) % width]};
        parts.push_back(builder.add_part("part", {}));
        builder.add_node({"thread"}, reads(needed), writes(parts.back()),
                         []() noexcept { be_busy(0.1e-6); });
      }
      before = std::move(parts);
    }
    return builder.build();
  }

  StepGraph graph_;
  Plan plan_;
};

// What a node costs is found on one thread; what starting it costs among threads is what the
// simulator needs to take as long as two threads did.
double measure_contention(const Overheads& overheads) {
  const Weave weave;
  const double alone = overheads.per_cluster;
  const double node = weave.measure(1) / weave.nodes() - alone;
  const double measured = weave.measure(2);
  double low = alone, high = 20.0 * alone;
  for (int k = 0; k < 20; ++k) {
    const double middle = 0.5 * (low + high);
    (weave.simulate(node, middle, overheads.handover) < measured ? low : high) = middle;
  }
  return (low - alone) * (low + node) / low;  // cluster_among_threads() turned round
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
// cache lines, as the parts of a step do: a processor that fetches ahead gains little.
struct Toucher {
  static constexpr std::size_t kPieces = 16, kPiece = 32, kStride = 160;  // doubles
  std::array<double, kPieces * kStride> data{};
  std::size_t pieces = kPieces;
  double seconds = 0.0;
  std::thread::id thread;

  void touch() noexcept {
    const std::uint64_t begin = time_stamp();
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      for (std::size_t k = 0; k < kPiece; ++k) data[7 * piece % kPieces * kStride + k] += 1.0;
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
double measure_moved(std::size_t pieces) {
  constexpr double time = 15e-3;  // s
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

Transfer measure_transfer() {
  constexpr auto bytes = static_cast<double>(Toucher::kPiece * sizeof(double));  // of a piece
  const double one = measure_moved(1);
  const double all = measure_moved(Toucher::kPieces);
  const double per_piece = std::max(0.0, (all - one) / (Toucher::kPieces - 1));
  return {std::clamp(one - per_piece, 0.0, 1e-6), std::min(per_piece / bytes, 4e-9)};
}

RuntimeCosts measure() {
  RuntimeCosts costs;
  costs.flow_graph = flow_graph_overheads();
  costs.flow_graph_run =
      std::clamp(measure_flow_graph_run(costs.flow_graph.per_cluster), 0.05e-6, 5e-6);
  costs.contention = std::clamp(measure_contention(costs.flow_graph), 0.0, 1e-6);
  costs.transfer = measure_transfer();
  if (has_openmp()) {
    costs.barrier_alone = std::clamp(measure_barrier_alone(), 1e-9, 5e-6);
    costs.barrier = std::clamp(measure_barrier(), 1e-9, 5e-6);
  }
  return costs;
}

}  // namespace

const RuntimeCosts& runtime_costs() {
  static const RuntimeCosts costs = measure();
  return costs;
}

// t = per_cluster + contention * t / (t + mean_work)
double cluster_among_threads(const RuntimeCosts& costs, double mean_work) {
  const double alone = costs.flow_graph.per_cluster;
  const double half = 0.5 * (mean_work - alone - costs.contention);
  return std::sqrt(half * half + alone * mean_work) - half;
}

RuntimeCosts scaled(const RuntimeCosts& costs, double factor) {
  RuntimeCosts result = costs;
  for (double* cost :
       {&result.flow_graph.per_node, &result.flow_graph.per_cluster, &result.flow_graph.handover,
        &result.contention, &result.flow_graph_run, &result.barrier, &result.barrier_alone,
        &result.transfer.latency, &result.transfer.per_byte})
    *cost *= factor;
  return result;
}

}  // namespace spoke::graph
