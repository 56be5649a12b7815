// What a simulation is asked beyond its steps: its frequencies at rest, and where its model stands.

#include "engine/bodies/kernels/plane/natural_frequencies.h"
#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "engine/simulation/simulation_core.h"
#include "engine/small_motions/vibration/frequency_limits.h"

namespace spoke {

LinearProperties Simulation::linear_properties() const {
  if (core_->given.space) {
    const vibration::FrequencyLimits limits = vibration::find_frequency_limits(core_->given);
    return {limits.lowest, limits.highest, limits.rk4.step};
  }
  const Rotor& rotor = core_->scenario.rotor;
  const plane::FrequencyRange range = plane::calc_frequency_range(rotor);
  return {range.lowest, range.highest, calc_rk4_step_with_drag(range, rotor)};
}

EquilibriumResult solve_equilibrium(const Simulation& simulation, const SteadyState& state) {
  Scenario scenario = simulation.scenario();
  Drive& drive = scenario.space ? scenario.space->hub.drive : scenario.rotor.hub.drive;
  drive = simulation.drive();
  if (scenario.space)
    for (spatial::Rotor& rotor : scenario.space->rotors)
      rotor.hub.drive = simulation.drive(rotor.hub.name);
  return solve_equilibrium(scenario, state);
}

}  // namespace spoke
