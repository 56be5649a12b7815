#pragma once

// Predicted and measured times of a scenario's step.

#include <optional>
#include <string>
#include <vector>

#include "bench/compare/rounds.h"
#include "bench/compare/statistics.h"
#include "bench/predict/nodes.h"
#include "bench/predict/ranks.h"
#include "engine/support/machine.h"

namespace spoke::predict {

using compare::Quartiles;

/// Measured times of an executor on some threads.
struct Measured {
  Quartiles step;     ///< time [s]
  Quartiles speedup;  ///< serial's time / time in the same round
};

/// A graph that executors run, one run after the other.
struct RunGraph {
  int window = 1;            ///< approximate number of steps that one run makes
  bool is_one_pass = false;  ///< a run is one pass over the step graph
  int node_count = 0, edge_count = 0;
  Nodes nodes = {};
  double work = 0.0, span = 0.0;  ///< T1 and Tinf per step [s]

  double parallelism() const { return work / span; }
};
/// Returns "windows of 94 steps", "runs of one pass" or, for passes of one step, "runs of some
/// passes".
std::string describe_runs(const RunGraph& run);

/// An executor on a number of threads.
struct Point {
  int threads = 1;
  int window = 1;                 ///< approximate number of steps that one run makes
  graph::PredictedRun step = {};  ///< times per step [s]
  std::optional<Measured> measured = {};

  /// Returns predicted / measured time - 1; none if nothing was measured.
  std::optional<double> error() const;
};

struct Series {
  ExecutorKind executor = ExecutorKind::serial;
  std::vector<Point> points = {};  ///< by number of threads
};

struct Prediction {
  Scenario scenario;  ///< with the values in force
  Formulation formulation = Formulation::structured;
  double step_size = 0.0;  ///< [s]
  ModelSize size = {};
  Machine machine = {};
  double load_before = -1.0, load_after = -1.0;  ///< runnable processes; -1: not known
  Capacity capacity = {};
  int rounds = 0;  ///< rounds of the measured points
  graph::RuntimeCosts runtime = {};
  RunGraph run = {};
  std::optional<RunGraph> auto_run = {};  ///< graph of auto on several threads, if it is another
  Point serial = {};
  std::vector<Series> series = {};  ///< the other executors
  Network network = {};
  std::vector<RankPoint> ranks = {};  ///< numbers of processes, ascending, if asked for

  double speedup(const Point& point) const { return serial.step.expected / point.step.expected; }
  double speedup(const RankPoint& point) const { return serial.step.expected / point.step(); }
};

/// Returns the executors of this build, besides serial, that can be predicted.
std::vector<ExecutorKind> predictable_executors();
/// Returns the executors of this build that cannot be predicted.
std::vector<ExecutorKind> left_out_executors();

/// Returns the bound of a point's time per step with the measured capacity of its threads on this
/// machine [s]; none if that is not known, or for more threads than processors.
std::optional<double> bound_at_capacity(const Prediction& prediction, ExecutorKind executor,
                                        const Point& point);

/// Fills in the points for `threads`, ascending, and T1 and Tinf of the graphs, from the graphs,
/// the costs of their nodes, and `runtime`. `auto_graph`: the graph of auto_run; null if there is
/// none.
void predict(Prediction& prediction, const graph::StepGraph& graph,
             const graph::StepGraph* auto_graph, const std::vector<int>& threads);

/// Puts measurements that compare::measure() made beside the points they belong to. Leaves out
/// those without times in several rounds.
void add_measured(Prediction& prediction, const std::vector<compare::Measurement>& measurements);

}  // namespace spoke::predict
