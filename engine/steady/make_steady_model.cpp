// Chooses the world of a scenario's model, and names its parts.

#include "engine/steady/steady_system.h"
#include "engine/step/model_memory.h"
#include "models/error.h"
#include "models/system/spatial_system.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

TreeNames name_blade(const Blade& blade, std::size_t index) {
  TreeNames names{"blade " + std::to_string(index + 1), {}, {}, blade.azimuth};
  for (int j = 0; j < blade.bodies; ++j) {
    names.bodies.push_back("body " + std::to_string(j + 1));
    names.joints.emplace_back();
  }
  return names;
}

TreeNames name_tree(const spatial::Tree& tree) {
  TreeNames names{tree.name, {}, {}, tree.azimuth};
  for (const spatial::TreeBody& body : tree.bodies) {
    names.bodies.push_back(body.name);
    names.joints.push_back(body.joint.name.empty() ? "joint of " + body.name : body.joint.name);
  }
  return names;
}

std::unique_ptr<SteadyModel> make_planar(const Rotor& rotor, const SteadyOptions& options) {
  std::vector<TreeNames> names;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i)
    names.push_back(name_blade(rotor.blades[i], i));
  const auto fill = [&rotor](System<Plane>& system) {
    system = make_system(rotor);
    require_memory(system, Formulation::structured);
  };
  return std::make_unique<SteadySystem<Plane>>(fill, std::move(names), options);
}

/// Pitch by the azimuth has a mean, whatever turns the hub.
std::unique_ptr<SteadyModel> make_spatial(const spatial::Model& model,
                                          const SteadyOptions& options) {
  if (model.hub.mount)
    throw InputError("hub.mount: the axle moves, expected one at rest to find an equilibrium");
  const std::vector<spatial::Tree> trees = build_trees(model);
  std::vector<TreeNames> names;
  for (const spatial::Tree& tree : trees) names.push_back(name_tree(tree));
  const auto fill = [&](System<Space>& system) {
    system = make_system(model, trees);
    require_memory(system, Formulation::structured);
  };
  return std::make_unique<SteadySystem<Space>>(fill, std::move(names), options);
}

}  // namespace

std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options) {
  return scenario.space ? make_spatial(*scenario.space, options)
                        : make_planar(scenario.rotor, options);
}

}  // namespace spoke::steady
