// Makes steps serially, with time stamps between the nodes in half of the runs.

#include "engine/simulation/node_measurement.h"

#include "engine/simulation/require_range.h"
#include "engine/simulation/simulation_core.h"
#include "graph/calibrate/measuring_executor.h"

namespace spoke {

NodeMeasurement measure_nodes(Simulation& simulation, std::int64_t steps) {
  SimulationCore& core = core_of(simulation);
  const std::int64_t begin = core.runner->steps();
  require_range("the number of steps to measure", steps, 1, core.planned_steps - begin);
  graph::MeasuringExecutor executor(core.runner->run_graph());
  core.measure(begin + steps, executor);
  return {executor.node_costs(), executor.run_times(), executor.between_runs(),
          static_cast<double>(executor.runs()) / static_cast<double>(steps)};
}

int open_window(Simulation& simulation) {
  SimulationCore& core = core_of(simulation);
  core.open_window();
  return core.runner->run_steps();
}

}  // namespace spoke
