// Chooses the world of a scenario's model.

#include <memory>
#include <utility>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/small_motions/steady/friction_at_rest.h"
#include "engine/small_motions/steady/make_supported.h"
#include "engine/small_motions/steady/mean_wind.h"
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

/// Refuses anchors beside the axle: of the rotor alone, which a steady model eliminates first,
/// their forces would be the hub's.
void require_hub_anchors(const spatial::Model& model) {
  for (std::size_t i = 0; i < model.anchors.size(); ++i)
    if (model.anchors[i].frame == Anchor::Frame::axle)
      throw InputError(
          "anchor." + std::to_string(i + 1) +
          ".frame: is \"axle\", expected \"hub\": a steady state takes the rotor apart "
          "from its support, and this anchor is on both; runs have it");
}

/// Returns what carries a tree: the number of a rotor, or -1, of the support.
int find_carrier(const spatial::Model& model, std::size_t tree) {
  if (tree < model.blades.size()) return model.blades[tree].rotor;
  const spatial::Subsystem& subsystem = model.subsystems[tree - model.blades.size()];
  return is_support(model, subsystem) ? -1 : subsystem.rotor;
}

/// Refuses loops and couplings between subsystems of different hubs, or of a hub and the support:
/// these turn against one another.
void require_loops_on_hubs(const spatial::Model& model) {
  const auto require = [&model](std::size_t tree, const std::vector<Loop>& loops,
                                const std::vector<Coupling>& couplings, const std::string& key) {
    const auto is_on_hub = [&](std::size_t other) {
      return find_carrier(model, other) == find_carrier(model, tree);
    };
    for (std::size_t k = 0; k < couplings.size(); ++k)
      for (const CoupledJoint& at : couplings[k].joints)
        if (at.is_elsewhere() && !is_on_hub(spatial::find_tree(model, at.blade, at.subsystem)))
          throw InputError(key + ".coupling." + std::to_string(k + 1) +
                           ".joints: are on several hubs or a support, expected those of one: a "
                           "steady state takes what turns by itself; runs have it");
    for (std::size_t k = 0; k < loops.size(); ++k)
      if (loops[k].to.carrier == LoopPlace::Carrier::elsewhere &&
          !is_on_hub(spatial::find_tree(model, loops[k].to)))
        throw InputError(key + ".loop." + std::to_string(k + 1) +
                         ".to: is on another hub or a support, expected a place on the same one: a "
                         "steady state takes what turns by itself; runs have it");
  };
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    require(i, model.blades[i].loops, model.blades[i].couplings, "blades." + std::to_string(i + 1));
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    require(model.blades.size() + i, model.subsystems[i].loops, model.subsystems[i].couplings,
            key_of_subsystem(model, i));
}

/// Refuses rotors on others: what carries them turns, or is an unknown of another rotor.
void require_rotors_on_support(const spatial::Model& model) {
  for (int r = 0; model.support && r < count_rotors(model); ++r)
    if (const std::string& carrier = axle_of(model, r).subsystem; !carrier.empty())
      throw InputError("rotor." + std::to_string(r + 1) + ".axle.subsystem: is \"" + carrier +
                       "\", expected the support: a steady state has no rotor on what a rotor "
                       "carries; runs have it");
}

/// Refuses couplings on axles: their coordinates are of a rotor and of the support.
void require_free_axles(const spatial::Model& model) {
  if (!model.support) return;
  const std::vector<Coupling>& couplings = model.subsystems.back().couplings;
  for (int r = 0; r < count_rotors(model); ++r) {
    const std::string axle = prefix_of_rotor(model, r) + "axle";
    for (std::size_t k = 0; k < couplings.size(); ++k)
      for (const CoupledJoint& at : couplings[k].joints)
        if (at.joint == axle)
          throw InputError("support.coupling." + std::to_string(k + 1) + ": couples \"" + axle +
                           "\": a steady state takes the rotor apart from its support, and this is "
                           "on both; runs have it");
  }
}

/// Pitch by the azimuth has a mean whether a drive or torque turns the hub.
std::unique_ptr<SteadyModel> make_spatial(const Scenario& scenario, const SteadyWinds& winds,
                                          const SteadyOptions& options) {
  const spatial::Model& model = *scenario.space;
  require_hub_anchors(model);
  require_free_axles(model);
  require_loops_on_hubs(model);
  require_rotors_on_support(model);
  if (model.support) return make_supported(scenario, winds, options);
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
  require_hub_anchors(*scenario.space);
  require_free_axles(*scenario.space);
  require_rotors_on_support(*scenario.space);
  if (has_friction(scenario))
    return make_rotor_model(with_friction_at_rest(scenario), rotor, options);
  if (has_changing_wind(scenario))
    return make_rotor_model(in_mean_wind(scenario, options.instant, WindPlaces::hub, rotor), rotor,
                            options);
  return scenario.space->support ? make_single_rotor(scenario, rotor, options)
                                 : make_spatial(scenario, {}, options);
}

}  // namespace spoke::steady
