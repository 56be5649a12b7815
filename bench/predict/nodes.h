#pragma once

// What the nodes of a graph cost, timed in rounds.

#include <cstdint>

#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "graph/tune/run_prediction.h"

namespace spoke::predict {

/// What the nodes of a simulation's step cost.
struct Nodes {
  NodeMeasurement serial = {};    ///< medians; `run_times` of all measurements
  graph::CostSpread spread = {};  ///< quartiles of the times of runs over their median
  std::int64_t steps = 0;         ///< measured in all
};

/// Steps that take about `seconds`, as a whole number of windows; at least 8 windows, and no more
/// stamps than some memory holds. Makes a few steps of the simulation to find out.
std::int64_t choose_steps(Simulation& simulation, double seconds);

/// Times the nodes of one simulation.
class NodeTimer {
 public:
  explicit NodeTimer(Simulation& simulation) : simulation_(simulation) {}

  /// Makes that many steps.
  void measure(std::int64_t steps);
  /// Medians over the calls of measure(), of which there must be one.
  Nodes summarise() const;

 private:
  Simulation& simulation_;
  std::vector<NodeMeasurement> rounds_;
  std::int64_t steps_ = 0;
};

}  // namespace spoke::predict
