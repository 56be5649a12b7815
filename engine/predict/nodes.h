#pragma once

#include <cstdint>

#include "engine/simulation.h"
#include "graph/run_prediction.h"

namespace spoke::predict {

/// What the nodes of a simulation's step cost.
struct Nodes {
  NodeMeasurement mean = {};             ///< serially; `run_times` of all measurements
  std::vector<double> level_costs = {};  ///< as `mean.costs`, level by level; empty without OpenMP
  graph::CostSpread spread = {};         ///< quartiles of the times of runs over their median
  std::int64_t steps = 0;                ///< measured in all, per order

  graph::OrderedCosts costs() const { return {mean.costs, level_costs}; }
};

/// Steps that take about `seconds` node by node, as a whole number of windows; at least 8 windows,
/// and no more stamps than some memory holds. Makes a few steps of the simulation to find out.
std::int64_t choose_steps(Simulation& simulation, double seconds);

/// Times the nodes of one simulation, in each order that an executor to be predicted runs them.
class NodeTimer {
 public:
  explicit NodeTimer(Simulation& simulation) : simulation_(simulation) {}

  /// Makes that many steps per order.
  void measure(std::int64_t steps);
  /// The mean of all that was measured. Precondition: measure() was called.
  Nodes summarise() const;

  /// How many times the steps of measure() are made.
  static int orders();

 private:
  Simulation& simulation_;
  std::vector<NodeMeasurement> serial_, levels_;
  std::int64_t steps_ = 0;
};

}  // namespace spoke::predict
