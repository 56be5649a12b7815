#pragma once

// What the nodes of a graph cost, timed in rounds.

#include <cstdint>

#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "graph/tune/run_prediction.h"

namespace spoke::predict {

/// What the nodes of a simulation's step cost.
struct Nodes {
  NodeMeasurement serial = {};           ///< medians; `run_times` of all measurements
  std::vector<double> level_costs = {};  ///< as `serial.costs`, level by level, or none: no OpenMP
  graph::CostSpread spread = {};         ///< quartiles of the times of runs over their median
  std::int64_t steps = 0;                ///< measured in all

  graph::OrderedCosts costs() const { return {serial.costs, level_costs}; }
};

/// Steps that take about `seconds`, as a whole number of windows; at least 8 windows, and no more
/// stamps than some memory holds. Makes a few steps of the simulation to find out.
std::int64_t choose_steps(Simulation& simulation, double seconds);

/// Times the nodes of one simulation, in each order that an executor to be predicted runs them.
class NodeTimer {
 public:
  /// `by_levels`: whether openmp_levels, if this build has it, is among them.
  explicit NodeTimer(Simulation& simulation, bool by_levels = true)
      : simulation_(simulation),
        by_levels_(by_levels && graph::has_executor(ExecutorKind::openmp_levels)) {}

  /// Makes that many steps, at least 2, an equal share of them in each order.
  void measure(std::int64_t steps);
  /// Medians over the calls of measure(), of which there must be one.
  Nodes summarise() const;

 private:
  Simulation& simulation_;
  bool by_levels_;
  std::vector<NodeMeasurement> serial_, levels_;
  std::int64_t steps_ = 0;
};

}  // namespace spoke::predict
