// Holds the axles that are driven, and makes the system that a run has.

#include "engine/small_motions/steady/standing_machine.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/small_motions/steady/steady_mount.h"
#include "engine/small_motions/steady/tied_model.h"
#include "engine/step/loops/loop_start.h"
#include "engine/step/model_memory.h"
#include "engine/support/memory.h"
#include "models/error.h"
#include "models/space/space.h"
#include "models/system/spatial_system.h"
#include "models/tree/anchors_on_bodies.h"
#include "models/tree/axle_carrier.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

/// Returns what carries a tree: the number of a rotor, or -1, of the support.
int find_carrier(const spatial::Model& model, std::size_t tree) {
  if (tree < model.blades.size()) return model.blades[tree].rotor;
  const spatial::Subsystem& subsystem = model.subsystems[tree - model.blades.size()];
  return is_support(model, subsystem) ? -1 : subsystem.rotor;
}

/// Finds a loop or a coupling of a tree that is on another hub, too.
std::string find_loop_across(const spatial::Model& model, std::size_t tree,
                             const std::vector<Loop>& loops, const std::vector<Coupling>& couplings,
                             const std::string& key) {
  const auto is_on_other_hub = [&](std::size_t other) {
    return find_carrier(model, other) != find_carrier(model, tree);
  };
  for (std::size_t k = 0; k < couplings.size(); ++k)
    for (const CoupledJoint& at : couplings[k].joints)
      if (at.is_elsewhere() && is_on_other_hub(spatial::find_tree(model, at.blade, at.subsystem)))
        return key + ".coupling." + std::to_string(k + 1) +
               ".joints: are on several hubs, or a hub and the support";
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (loops[k].to.carrier == LoopPlace::Carrier::elsewhere &&
        is_on_other_hub(spatial::find_tree(model, loops[k].to)))
      return key + ".loop." + std::to_string(k + 1) + ".to: is on another hub or the support";
  return {};
}

std::string find_any_loop_across(const spatial::Model& model) {
  std::string found;
  for (std::size_t i = 0; found.empty() && i < model.blades.size(); ++i)
    found = find_loop_across(model, i, model.blades[i].loops, model.blades[i].couplings,
                             "blades." + std::to_string(i + 1));
  for (std::size_t i = 0; found.empty() && i < model.subsystems.size(); ++i)
    found = find_loop_across(model, model.blades.size() + i, model.subsystems[i].loops,
                             model.subsystems[i].couplings, key_of_subsystem(model, i));
  return found;
}

/// Finds a coupling of the support that couples an axle.
std::string find_coupled_axle(const spatial::Model& model) {
  const std::vector<Coupling>& couplings = model.subsystems.back().couplings;
  for (int r = 0; r < count_rotors(model); ++r) {
    const std::string axle = prefix_of_rotor(model, r) + "axle";
    for (std::size_t k = 0; k < couplings.size(); ++k)
      for (const CoupledJoint& at : couplings[k].joints)
        if (at.joint == axle)
          return "support.coupling." + std::to_string(k + 1) + ": couples \"" + axle + '"';
  }
  return {};
}

/// Holds what drives prescribe.
void hold_drives(spatial::Model& model) {
  for (int r = 0; r < count_rotors(model); ++r) {
    Drive& drive = (r == 0 ? model.hub : model.rotors[static_cast<std::size_t>(r) - 1].hub).drive;
    if (prescribes_motion(drive)) {
      drive = FixedDrive{};
    } else if (!std::holds_alternative<FreeDrive>(drive)) {
      const std::string& name = hub_of(model, r).name;
      throw InputError((r > 0 ? "the drive of the rotor \"" + name + '"' : "hub.drive") +
                       ": is a torque, expected one that prescribes the motion, or none: "
                       "nothing says which torque holds a machine at rest whose hubs are tied");
    }
  }
}

}  // namespace

std::string find_tie_of_hubs(const spatial::Model& given) {
  if (!given.support) return {};
  const std::optional<spatial::Model> put = spatial::put_on_bodies_of_anchors(given);
  const spatial::Model& model = put ? *put : given;
  for (std::size_t i = 0; i < model.anchors.size(); ++i)
    if (model.anchors[i].frame == Anchor::Frame::axle)
      return "anchor." + std::to_string(i + 1) + ".frame: is \"axle\", beside the hub";
  for (int r = 0; r < count_rotors(model); ++r)
    if (const std::string& carrier = axle_of(model, r).subsystem; !carrier.empty())
      return "rotor." + std::to_string(r + 1) +
             (find_blade_of(axle_of(model, r)) > 0 ? ".axle.blade: is on " + carrier
                                                   : ".axle.subsystem: is \"" + carrier + '"') +
             ", which another rotor carries";
  const std::string axle = find_coupled_axle(model);
  return axle.empty() ? find_any_loop_across(model) : axle;
}

std::unique_ptr<SteadyModel> make_standing(const Scenario& scenario, const SteadyWinds& winds,
                                           const SteadyOptions& options) {
  spatial::Model model = *scenario.space;
  hold_drives(model);
  if (winds.at_places) model.air->wind = *winds.at_places;
  const std::vector<spatial::Tree> trees = build_trees(model);
  System<Space> system = make_system(model, trees, {{}, available_memory()});
  hold_mount(system.hub, options.instant);
  require_memory(system, Formulation::structured);
  SteadyOptions whole = options;
  whole.is_whole = model.support->from != spatial::SupportBase::free;
  std::vector<std::string> rotors;
  for (int r = 0; r < count_rotors(model); ++r) rotors.push_back(hub_of(model, r).name);
  return std::make_unique<TiedModel>(
      make_space(system, scenario.sensors, trees, model.blades.size(),
                 make_loop_limits(scenario.integration), whole),
      std::move(rotors));
}

}  // namespace spoke::steady
