// Measures clusters, handovers and barriers on calibration graphs.

#include "graph/calibrate/runtime_costs.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "graph/calibrate/calibration_graphs.h"
#include "graph/calibrate/timed_runs.h"
#include "graph/execute/executor_kinds.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {
namespace {

constexpr double kTime = 15e-3;    // s, time to measure one quantity
constexpr double kPatience = 0.1;  // s, since a sleeping thread takes milliseconds to join, on a
                                   // virtual machine tens of them

// Measures the time of one thread for a cluster of forks and joins of empty nodes [s], which cost
// more than links of a chain. Their place in memory makes some 10 %, so it is the mean of several
// places.
double measure_cluster() {
  const StepGraph graph = make_fork_joins(330, 0.0);
  constexpr int places = 5;
  constexpr double time = 1e-3;                      // s, time for one place
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

// Returns the time of fork-joins whose two nodes are busy for so long, on two threads [s].
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

// Measures the time of a handover: each fork-join makes one, so runs of many are longer by as many.
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

// Measures the barrier of one thread, which has none within a run, but two between one run and the
// next.
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

}  // namespace

RuntimeCosts measure_runtime_costs() {
  RuntimeCosts costs;
  costs.flow_graph.per_cluster = std::clamp(measure_cluster(), 10e-9, 1e-6);
  costs.flow_graph.handover =
      std::clamp(measure_handover(costs.flow_graph.per_cluster), 0.1e-6, 5e-6);
#ifdef SPOKE_HAS_OPENMP
  costs.barrier_alone = std::clamp(measure_barrier_alone(), 1e-9, 5e-6);
  costs.barrier = std::clamp(measure_barrier(), 1e-9, 5e-6);
#endif
  return costs;
}

}  // namespace spoke::graph
