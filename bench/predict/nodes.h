#pragma once

// Costs of a graph's nodes, timed in rounds.

#include <cstdint>

#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "graph/tune/run_prediction.h"

namespace spoke::predict {

/// Costs of the nodes of a simulation's step.
struct Nodes {
  NodeMeasurement serial = {};    ///< medians; `run_times` of all measurements
  graph::CostSpread spread = {};  ///< quartiles of the times of runs over their median
  std::int64_t steps = 0;         ///< number of measured steps
};

/// Returns a number of steps that take about `seconds`: a whole number of windows, at least 8, with
/// no more stamps than fit into 64 MB. Makes a few steps of the simulation to find out.
std::int64_t choose_steps(Simulation& simulation, double seconds);

/// Times the nodes of one simulation.
class NodeTimer {
 public:
  explicit NodeTimer(Simulation& simulation) : simulation_(simulation) {}

  /// Makes that many steps and times their nodes.
  void measure(std::int64_t steps);
  /// Returns medians over the calls of measure(). Precondition: measure() was called.
  Nodes summarise() const;

 private:
  Simulation& simulation_;
  std::vector<NodeMeasurement> rounds_;
  std::int64_t steps_ = 0;
};

}  // namespace spoke::predict
