// Chooses the world of a scenario's model.

#include <memory>
#include <utility>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/small_motions/steady/friction_at_rest.h"
#include "engine/small_motions/steady/make_supported.h"
#include "engine/small_motions/steady/mean_wind.h"
#include "engine/small_motions/steady/standing_machine.h"
#include "engine/small_motions/steady/steady_mount.h"
#include "engine/small_motions/steady/steady_system.h"
#include "engine/step/loops/loop_start.h"
#include "engine/step/model_memory.h"
#include "engine/support/memory.h"
#include "models/error.h"
#include "models/system/spatial_system.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

std::unique_ptr<SteadyModel> make_planar(const Scenario& scenario, const SteadyOptions& options) {
  const Rotor& rotor = scenario.rotor;
  const auto fill = [&rotor](System<Plane>& system) {
    system = make_system(rotor);
    require_memory(system, Formulation::structured);
  };
  const auto place = [&scenario](const System<Plane>&, StepData<Plane>& data) {
    return place_sensors(scenario.sensors, scenario.rotor, data);
  };
  return std::make_unique<SteadySystem<Plane>>(
      SystemMaker<Plane>{fill, place, make_loop_limits(scenario.integration)},
      name_subsystems(rotor), options);
}

bool has_unsteady_flow(const Scenario& scenario) {
  const auto& air = scenario.space->air;
  return air && air->attached_flow == spatial::AttachedFlow::unsteady;
}

/// Returns the scenario with lift that follows at once: small motions have no states of air.
Scenario with_steady_flow(const Scenario& scenario) {
  Scenario steady = scenario;
  steady.space->air->attached_flow = spatial::AttachedFlow::steady;
  return steady;
}

bool turns(const SteadyOptions& options) {
  return options.speed != 0.0 ||
         std::any_of(options.further_speeds.begin(), options.further_speeds.end(),
                     [](double speed) { return speed != 0.0; });
}

[[noreturn]] void refuse_turning(const std::string& tie) {
  throw InputError(tie +
                   ": while hubs turn it changes with their azimuths, and a steady state is "
                   "constant; runs have it, and steady states at rest");
}

/// Pitch by the azimuth has a mean whether a drive or torque turns the hub.
std::unique_ptr<SteadyModel> make_spatial(const Scenario& scenario, const SteadyWinds& winds,
                                          const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  if (model.support) {
    const std::string tie = find_tie_of_hubs(model);
    if (!tie.empty() && turns(options)) refuse_turning(tie);
    return tie.empty() ? make_supported(scenario, winds, options)
                       : make_standing(scenario, winds, options);
  }
  const std::vector<spatial::Tree> trees = build_trees(model);
  System<Space> system = make_system(model, trees, {{}, available_memory()});
  hold_mount(system.hub, options.instant);
  require_memory(system, Formulation::structured);
  return make_part(system, scenario.sensors, trees, model.blades.size(),
                   make_loop_limits(scenario.integration), options);
}

}  // namespace

std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options) {
  if (!scenario.space) return make_planar(scenario, options);
  if (has_friction(scenario)) return make_steady_model(with_friction_at_rest(scenario), options);
  if (has_unsteady_flow(scenario)) return make_steady_model(with_steady_flow(scenario), options);
  if (!has_changing_wind(scenario)) return make_spatial(scenario, {}, options);
  const Scenario of_places = in_mean_wind(scenario, options.instant, WindPlaces::all);
  SteadyWinds winds{{}, &of_places.space->air->wind};
  if (options.is_whole) return make_spatial(of_places, winds, options);
  for (int r = 0; r < count_rotors(*scenario.space); ++r)
    winds.of_rotors.push_back(
        in_mean_wind(scenario, options.instant, WindPlaces::hub, r).space->air->wind);
  return make_spatial(in_mean_wind(scenario, options.instant, WindPlaces::hub), winds, options);
}

std::unique_ptr<SteadyModel> make_rotor_model(const Scenario& scenario, int rotor,
                                              const SteadyOptions& options) {
  assert(scenario.space);
  if (const std::string tie = find_tie_of_hubs(*scenario.space); !tie.empty()) refuse_turning(tie);
  if (has_friction(scenario))
    return make_rotor_model(with_friction_at_rest(scenario), rotor, options);
  if (has_unsteady_flow(scenario))
    return make_rotor_model(with_steady_flow(scenario), rotor, options);
  if (has_changing_wind(scenario))
    return make_rotor_model(in_mean_wind(scenario, options.instant, WindPlaces::hub, rotor), rotor,
                            options);
  return scenario.space->support ? make_single_rotor(scenario, rotor, options)
                                 : make_spatial(scenario, {}, options);
}

}  // namespace spoke::steady
