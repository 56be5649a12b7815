// Chooses the world of a scenario's model.

#include "engine/columns/spatial_columns.h"
#include "engine/steady/steady_mount.h"
#include "engine/steady/steady_system.h"
#include "engine/step/loop_start.h"
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

/// Pitch by the azimuth has a mean whether a drive or torque turns the hub.
std::unique_ptr<SteadyModel> make_spatial(const Scenario& scenario, const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  if (model.support)
    throw InputError(
        "support: equilibria, modes and linear models of a rotor on a support are not there yet, "
        "expected no [support] and no [hub.suspension]; spoke run takes them");
  const std::vector<spatial::Tree> trees = build_trees(model);
  const auto fill = [&](System<Space>& system) {
    system = make_system(model, trees, {{}, available_memory()});
    hold_mount(system.hub, options.instant);
    require_memory(system, Formulation::structured);
  };
  const auto place = [&](const System<Space>& system, StepData<Space>& data) {
    std::vector<SensorColumn> columns =
        place_sensors(scenario.sensors, model.blades.size(), trees, system, data);
    make_reading_rings(data);
    return columns;
  };
  return std::make_unique<SteadySystem<Space>>(
      SystemMaker<Space>{fill, place, make_loop_limits(scenario.integration)},
      name_subsystems(trees), options);
}

}  // namespace

std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options) {
  return scenario.space ? make_spatial(scenario, options) : make_planar(scenario, options);
}

}  // namespace spoke::steady
