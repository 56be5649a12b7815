#pragma once

// What is predicted of a scenario's step, and what was measured of it.

#include <optional>
#include <vector>

#include "engine/compare/rounds.h"
#include "engine/machine.h"
#include "engine/predict/nodes.h"

namespace spoke::predict {

/// A median and quartiles over rounds.
struct Quartiles {
  double low = 0.0, median = 0.0, high = 0.0;
};

/// What was measured of an executor on some threads.
struct Measured {
  Quartiles step;     ///< time [s]
  Quartiles speedup;  ///< serial's time / time in the same round
};

/// An executor on a number of threads.
struct Point {
  int threads = 1;
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
  int window = 1;          ///< steps that one run may make
  double step_size = 0.0;  ///< [s]
  ModelSize size = {};
  int run_nodes = 0, run_edges = 0;  ///< of the graph of one run
  Machine machine = {};
  double load_before = -1.0, load_after = -1.0;  ///< runnable processes; -1: not known
  int rounds = 0;                                ///< of the measured points
  graph::RuntimeCosts runtime = {};
  Nodes nodes = {};
  double work = 0.0, span = 0.0;  ///< T1 and Tinf per step [s]
  Point serial = {};
  std::vector<Series> series = {};  ///< of the other executors

  double parallelism() const { return work / span; }
  double speedup(const Point& point) const { return serial.step.expected / point.step.expected; }
};

/// The executors that predictions are made of in this build, besides serial.
std::vector<ExecutorKind> predictable_executors();

/// Fills in work, span and points for `threads`, ascending, from graph, nodes and runtime.
void predict(Prediction& prediction, const graph::StepGraph& graph,
             const std::vector<int>& threads);

/// Puts measurements, as by compare::measure(), beside the points they belong to. Those that gave
/// no time in several rounds are left out.
void add_measured(Prediction& prediction, const std::vector<compare::Measurement>& measurements);

}  // namespace spoke::predict
