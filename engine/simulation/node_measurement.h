#pragma once

// Times of nodes within the steps of a simulation, for predictions, comparisons and benchmarks.

#include <cstdint>
#include <vector>

namespace spoke {

class Simulation;

/// What the nodes of a simulation's run_graph() cost within its steps.
struct NodeMeasurement {
  std::vector<double> costs;      ///< by index of the node, mean per run [s]
  std::vector<double> run_times;  ///< of all nodes, in the runs without time stamps [s]
  double between_runs = 0.0;      ///< from the end of a run to the start of the next [s]
  double runs_per_step = 0.0;     ///< of the graph, mean
};

/// Makes `steps` steps as Simulation::run_until() does, to the same bits, but on one thread, in
/// half of the runs with a time stamp between any two nodes, 8 bytes each meanwhile. Throws
/// DivergenceError, and InputError unless 1 <= steps <= planned_steps() - steps(); should be 2
/// windows or more.
NodeMeasurement measure_nodes(Simulation& simulation, std::int64_t steps);

/// Of the executor auto on several threads: builds the graph of the window that it chooses for
/// simulations that are long enough to plan for, without planning; Simulation::run_graph() is then
/// that, for measure_nodes(). Makes the steps that the choice is timed by, unless run_until() has
/// chosen. Steps that a run of run_graph() makes, about. Throws like run_until().
int open_window(Simulation& simulation);

/// The subsystems that each of so many processes would have: its first one, and at the end their
/// number. Throws InputError unless 1 <= processes <= subsystems.
std::vector<int> share_subsystems(Simulation& simulation, int processes);

}  // namespace spoke
