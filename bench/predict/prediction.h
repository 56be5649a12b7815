#pragma once

// What is predicted of a scenario's step, and what was measured of it.

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

/// What was measured of an executor on some threads.
struct Measured {
  Quartiles step;     ///< time [s]
  Quartiles speedup;  ///< serial's time / time in the same round
};

/// A graph that executors run, one run after the other.
struct RunGraph {
  int window = 1;            ///< steps that one run makes, about
  bool is_one_pass = false;  ///< a run is one pass over the step graph
  int node_count = 0, edge_count = 0;
  Nodes nodes = {};
  double work = 0.0, span = 0.0;  ///< T1 and Tinf per step [s]

  double parallelism() const { return work / span; }
};
/// "windows of 94 steps", "runs of one pass", "runs of some passes" of one step.
std::string describe_runs(const RunGraph& run);

/// An executor on a number of threads.
struct Point {
  int threads = 1;
  int window = 1;                 ///< as RunGraph::window, of what is run
  graph::PredictedRun step = {};  ///< times per step [s]
  std::optional<Measured> measured = {};

  /// Predicted / measured time - 1; nothing where nothing was measured.
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
  int rounds = 0;  ///< of the measured points
  graph::RuntimeCosts runtime = {};
  RunGraph run = {};
  std::optional<RunGraph> auto_run = {};  ///< auto's on several threads, if it is another
  Point serial = {};
  std::vector<Series> series = {};  ///< of the other executors
  Network network = {};
  std::vector<RankPoint> ranks = {};  ///< on several processes, ascending; none unless asked for

  double speedup(const Point& point) const { return serial.step.expected / point.step.expected; }
  double speedup(const RankPoint& point) const { return serial.step.expected / point.step(); }
};

/// The executors that predictions are made of in this build, besides serial.
std::vector<ExecutorKind> predictable_executors();
/// The others of this build.
std::vector<ExecutorKind> left_out_executors();

/// The bound of a point's time per step with what its threads really do at once on this machine
/// [s]; nothing if that is not known, or for more threads than processors.
std::optional<double> bound_at_capacity(const Prediction& prediction, ExecutorKind executor,
                                        const Point& point);

/// Fills in points for `threads`, ascending, and T1 and Tinf of the graphs, from these, what their
/// nodes cost, and runtime. `auto_graph`: that of auto_run, if there is one.
void predict(Prediction& prediction, const graph::StepGraph& graph,
             const graph::StepGraph* auto_graph, const std::vector<int>& threads);

/// Puts measurements, as by compare::measure(), beside the points they belong to. Those that gave
/// no time in several rounds are left out.
void add_measured(Prediction& prediction, const std::vector<compare::Measurement>& measurements);

}  // namespace spoke::predict
