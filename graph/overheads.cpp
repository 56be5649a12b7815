#include "graph/overheads.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "graph/calibration_graphs.h"
#include "graph/executor_kinds.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

constexpr double kBusy = 20e-6;  // s

// What one thread takes for a cluster of forks and joins of empty nodes [s], which cost more than
// links of a chain. Where in memory they lie makes some 10 %: the least of several places.
double seconds_per_cluster(const StepGraph& graph) {
  constexpr int places = 3;
  constexpr double time = 1e-3;                      // s, of a place
  std::vector<std::unique_ptr<Executor>> executors;  // all live, so that each has its own place
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < places; ++k) {
    executors.push_back(make_flow_graph_executor(graph, plan_of_single_nodes(graph), 1));
    for (const std::uint64_t begin = time_stamp(); seconds_since(begin) < time;)
      least = std::min(least, seconds_per_run(*executors.back(), 20));
  }
  return least / graph.node_count();
}

// The more branches a fork has, the more clusters its thread keeps for later: all but one of each.
void measure_clusters(Overheads& overheads) {
  constexpr int nodes = 200, few = 2, many = 16;
  const auto seconds_and_kept = [](int branches) {
    const int forks = nodes / (1 + branches);
    const StepGraph graph = make_fork_joins(forks, 0.0, branches);
    return std::pair(seconds_per_cluster(graph),
                     static_cast<double>(forks * (branches - 1)) / graph.node_count());
  };
  const auto [seconds_of_few, kept_of_few] = seconds_and_kept(few);
  const auto [seconds_of_many, kept_of_many] = seconds_and_kept(many);
  overheads.keeping =
      std::clamp((seconds_of_many - seconds_of_few) / (kept_of_many - kept_of_few), 0.0, 0.2e-6);
  overheads.per_cluster = std::clamp(seconds_of_few - kept_of_few * overheads.keeping, 10e-9, 1e-6);
}

// A fork and join of two nodes takes one of them, one handover to the other thread and one back.
double measure_handover() {
  const StepGraph graph = make_fork_joins(1, kBusy);
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 2);
  // A thread that is new or asleep takes milliseconds to join, on a virtual machine tens of them.
  constexpr double patience = 0.1;   // s
  constexpr double joined = 2.0e-6;  // s, less than that only with another thread
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint64_t begin = time_stamp();
       least > joined && seconds_since(begin) < patience;) {
    least = std::min(least, 0.5 * (seconds_per_run(*executor, 100) - kBusy));
  }
  return least;
}

}  // namespace

Overheads measure_flow_graph_overheads() {
  Overheads overheads;
  measure_clusters(overheads);
  overheads.handover = std::clamp(measure_handover(), 0.5e-6, 5e-6);
  return overheads;
}

const Overheads& flow_graph_overheads() {
  static const Overheads overheads = measure_flow_graph_overheads();
  return overheads;
}

}  // namespace spoke::graph
