#include "graph/overheads.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "graph/calibration_graphs.h"
#include "graph/executor_kinds.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

constexpr double kBusy = 20e-6;  // s

// Clusters that fork and join, as those of a step do, cost more than links of a chain.
double measure_cluster() {
  const StepGraph graph = make_fork_joins(70, 0.0);
  const auto executor = make_flow_graph_executor(graph, plan_of_single_nodes(graph), 1);
  constexpr double time = 3e-3;  // s
  double least = seconds_per_run(*executor, 30);
  for (const std::uint64_t begin = time_stamp(); seconds_since(begin) < time;)
    least = std::min(least, seconds_per_run(*executor, 30));
  return least / graph.node_count();
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
  overheads.per_cluster = std::clamp(measure_cluster(), 10e-9, 1e-6);
  overheads.handover = std::clamp(measure_handover(), 0.5e-6, 5e-6);
  return overheads;
}

const Overheads& flow_graph_overheads() {
  static const Overheads overheads = measure_flow_graph_overheads();
  return overheads;
}

}  // namespace spoke::graph
