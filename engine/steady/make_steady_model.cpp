// Chooses the world of a scenario's model, and names its parts.

#include "engine/columns/spatial_columns.h"
#include "engine/steady/steady_mount.h"
#include "engine/steady/steady_system.h"
#include "engine/step/model_memory.h"
#include "models/system/spatial_system.h"
#include "models/tree/sensor_place.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

TreeNames name_blade(const Blade& blade, std::size_t index) {
  const std::string number = std::to_string(index + 1);
  TreeNames names{"blade " + number, {}, {}, "blade" + number, blade.azimuth};
  for (int j = 0; j < blade.bodies; ++j) {
    names.bodies.push_back("body " + std::to_string(j + 1));
    names.joints.emplace_back();
  }
  return names;
}

TreeNames name_tree(const spatial::Tree& tree) {
  TreeNames names{tree.name, {}, {}, sensor_name_of(tree), tree.azimuth};
  for (const spatial::TreeBody& body : tree.bodies) {
    names.bodies.push_back(body.name);
    names.joints.push_back(body.joint.name.empty() ? "joint of " + body.name : body.joint.name);
  }
  return names;
}

std::unique_ptr<SteadyModel> make_planar(const Scenario& scenario, const SteadyOptions& options) {
  const Rotor& rotor = scenario.rotor;
  std::vector<TreeNames> names;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i)
    names.push_back(name_blade(rotor.blades[i], i));
  const auto fill = [&rotor](System<Plane>& system) {
    system = make_system(rotor);
    require_memory(system, Formulation::structured);
  };
  const auto place = [&scenario](const System<Plane>&, StepData<Plane>& data) {
    return place_sensors(scenario.sensors, scenario.rotor, data);
  };
  return std::make_unique<SteadySystem<Plane>>(SystemMaker<Plane>{fill, place}, std::move(names),
                                               options);
}

/// Pitch by the azimuth has a mean, whatever turns the hub.
std::unique_ptr<SteadyModel> make_spatial(const Scenario& scenario, const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  const std::vector<spatial::Tree> trees = build_trees(model);
  std::vector<TreeNames> names;
  for (const spatial::Tree& tree : trees) names.push_back(name_tree(tree));
  const auto fill = [&](System<Space>& system) {
    system = make_system(model, trees);
    hold_mount(system.hub, options.instant);
    require_memory(system, Formulation::structured);
  };
  const auto place = [&](const System<Space>& system, StepData<Space>& data) {
    std::vector<SensorColumn> columns =
        place_sensors(scenario.sensors, model.blades.size(), trees, system, data);
    make_reading_rings(data);
    return columns;
  };
  return std::make_unique<SteadySystem<Space>>(SystemMaker<Space>{fill, place}, std::move(names),
                                               options);
}

}  // namespace

std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options) {
  return scenario.space ? make_spatial(scenario, options) : make_planar(scenario, options);
}

}  // namespace spoke::steady
