#pragma once

#include <cstdint>

#include "engine/simulation.h"
#include "graph/run_prediction.h"

namespace spoke::predict {

/// What the nodes of a simulation's step cost.
struct Nodes {
  NodeMeasurement mean = {};      ///< `run_times` of all measurements
  graph::CostSpread spread = {};  ///< quartiles of the times of runs over their median
  std::int64_t steps = 0;         ///< measured in all
};

/// Steps that take about `seconds` node by node, as a whole number of windows; at least 8 windows,
/// and no more stamps than some memory holds. Makes a few steps of the simulation to find out.
std::int64_t choose_steps(Simulation& simulation, double seconds);

/// The mean of measurements of the same simulation, `steps` steps each. Precondition: at least one.
Nodes summarise(const std::vector<NodeMeasurement>& measurements, std::int64_t steps);

}  // namespace spoke::predict
