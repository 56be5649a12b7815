// Copies a simulation at its state.

#include <memory>
#include <string>

#include "engine/simulation/simulation_core.h"
#include "models/error.h"

namespace spoke {

SimulationCore::SimulationCore(SimulationCore& original)
    : given(original.given),
      scenario(original.scenario),
      options(original.options),
      planned_steps(original.planned_steps),
      step_size(original.step_size),
      evaluations(original.evaluations),
      work(original.work),
      seen(original.seen),
      jumps(original.jumps),
      load_factors(original.load_factors),
      torques(original.torques),
      energy_resolution(original.energy_resolution),
      log(original.log),
      sensor_values(original.values()),
      measured_step(original.measured_step),
      identity_(original.identity_) {
  const RunnerOptions how = runner_options();
  const std::int64_t steps = original.runner->steps();
  model = original.model->copy(scenario, window_records(how, original.model->ring_bytes()), steps);
  if (original.control) control = original.control->clone(scenario);
  if (original.events) events = std::make_unique<Events>(*original.events);
  if (options.controller) options.controller = control->controller();
  runner = std::make_unique<StepRunner>(model->context(), how);
  runner->continue_from(steps);
}

std::unique_ptr<SimulationCore> SimulationCore::clone() {
  if (is_shared())
    throw InputError(std::to_string(options.exchange->count()) +
                     " processes simulate the model together: it cannot be cloned, expected one "
                     "process");
  if (is_calling_)
    throw StateError(
        "the simulation cannot be cloned by an observer or a load that it calls, "
        "expected a call between steps");
  require_state("clone");
  return std::unique_ptr<SimulationCore>(new SimulationCore(*this));
}

}  // namespace spoke
