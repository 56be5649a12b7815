// Finds the equilibrium of a scenario's model.

#include "engine/equilibrium.h"
#include "engine/steady/describe_equilibrium.h"
#include "engine/steady/steady_speed.h"
#include "engine/steady/steady_warnings.h"
#include "engine/steady/supported_model.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {

EquilibriumResult solve_equilibrium(const Scenario& scenario, const SteadyState& state) {
  check_scenario(scenario);
  const double speed = steady::find_steady_speed(scenario, state.speed);
  const std::unique_ptr<steady::SteadyModel> model = steady::make_steady_model(scenario, {speed});
  if (model->is_hub_free())
    throw InputError("hub.support: the hub is free, expected an axle: nothing holds the model");
  const steady::Equilibrium found = steady::find_machine_equilibrium(*model);
  steady::require_held(found);
  EquilibriumResult result = steady::describe(found, *model);
  steady::add_warnings(scenario, result);
  return result;
}

}  // namespace spoke
