#pragma once

// Times of nodes within the steps of a simulation, for traces, comparisons and benchmarks.

#include <cstdint>
#include <vector>

namespace spoke {

class Simulation;

/// Costs of the nodes of run_graph() within the steps of a simulation.
struct NodeMeasurement {
  std::vector<double> costs;      ///< by index of the node, mean per run [s]
  std::vector<double> run_times;  ///< time of all nodes in each run without time stamps [s]
  double between_runs = 0.0;      ///< from the end of a run to the start of the next [s]
  double runs_per_step = 0.0;     ///< mean number of runs of the graph per step
};

/// Makes `steps` steps as Simulation::run_until() does, to the same bits, but on one thread and
/// with a time stamp between any two nodes in half of the runs, which take 8 bytes each meanwhile.
/// `steps` should span 2 windows or more. Throws DivergenceError, and InputError unless 1 <= steps
/// <= planned_steps() - steps().
NodeMeasurement measure_nodes(Simulation& simulation, std::int64_t steps);

/// Builds the graph of the window that the executor auto chooses on several threads for simulations
/// that are long enough to plan for, without planning. Simulation::run_graph() is then this graph,
/// for measure_nodes(). Makes the steps by which the choice is timed, unless run_until() has chosen
/// before; if these are all, there is no window. Returns about how many steps a run of run_graph()
/// makes. Throws like run_until().
int open_window(Simulation& simulation);

}  // namespace spoke
