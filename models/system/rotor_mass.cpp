// Sums rotors up, level by level.

#include "models/system/rotor_mass.h"

#include <cstddef>
#include <variant>

#include "models/tree/mass_properties.h"

namespace spoke {
namespace {

/// Whether what carries a rotor is rigid and flies, and its hub with it: that moves as a free one
/// does.
bool is_one_with_fuselage(const spatial::Model& model, const std::vector<spatial::Tree>& trees,
                          int rotor) {
  if (!model.support || model.support->from == spatial::SupportBase::ground ||
      !std::holds_alternative<FixedDrive>(hub_of(model, rotor).drive))
    return false;
  const spatial::BodyAt hub = find_hub(trees, rotor);
  if (hub.tree + 1 < trees.size() && !is_one_with_fuselage(model, trees, trees[hub.tree].rotor))
    return false;
  const std::vector<spatial::TreeBody>& bodies = trees[hub.tree].bodies;
  for (int j = bodies[hub.body].parent; j >= 0; j = bodies[static_cast<std::size_t>(j)].parent) {
    const spatial::TreeBody& body = bodies[static_cast<std::size_t>(j)];
    if (!std::holds_alternative<spatial::RigidBody>(body.shape) ||
        body.joint.kind != spatial::JointKind::fixed)
      return false;
  }
  return true;
}

/// Whether a drive turns the hub of a rotor, or lets it turn.
bool turns(const spatial::Model& model, int rotor) {
  return !std::holds_alternative<FixedDrive>(hub_of(model, rotor).drive);
}

/// Returns the mass of a rotor, hub and blades and the rotors that these carry, and its first
/// moment, in the frame of its hub. Of a rotor that turns it is the mean over a turn.
spatial::MassProperties calc_rotor_mass(const spatial::Model& model,
                                        const std::vector<spatial::Tree>& trees, int number,
                                        bool is_turned) {
  const spatial::Hub& hub = hub_of(model, number);
  spatial::MassProperties rotor = spatial::make_mass_properties(hub.mass, hub.center, hub.inertia);
  for (std::size_t i = 0; i + 1 < trees.size(); ++i) {  // the last is the support
    if (trees[i].rotor != number) continue;
    const std::vector<spatial::Placement> placements = calc_placements(trees[i]);
    spatial::MassProperties tree;
    for (std::size_t j = 0; j < placements.size(); ++j) {
      const spatial::TreeBody& body = trees[i].bodies[j];
      tree += (body.is_hub() ? calc_rotor_mass(model, trees, body.rotor, turns(model, body.rotor))
                             : calc_mass_properties(trees[i], body))
                  .seen_from_outside(placements[j]);
    }
    rotor += tree;
  }
  const space::Rotation to_axis = axis_rotation(hub).inverse();
  rotor.first_moment = to_axis * space::Position(rotor.first_moment);
  if (is_turned) rotor.first_moment.head<2>().setZero();
  rotor.inertia.setZero();
  return rotor;
}

}  // namespace

std::vector<CarriedRotor> list_carried(const spatial::Model& model,
                                       const std::vector<spatial::Tree>& trees) {
  std::vector<CarriedRotor> rotors;
  for (int r = 0; r < count_rotors(model); ++r)
    rotors.push_back({calc_rotor_mass(model, trees, r, turns(model, r)), hub_of(model, r).drive});
  return rotors;
}

MachineCentre find_machine_centre(const spatial::Model& model,
                                  const std::vector<spatial::Tree>& trees) {
  MachineCentre centre;
  centre.from_hubs.assign(static_cast<std::size_t>(count_rotors(model)), space::Position::Zero());
  if (!model.support || model.support->from == spatial::SupportBase::ground) return centre;
  const spatial::Tree& support = trees.back();
  const std::vector<spatial::Placement> placements = calc_placements(support);
  const spatial::Fuselage& fuselage = model.support->fuselage;
  double mass = fuselage.mass;
  space::Position moment = fuselage.mass * space::Position(fuselage.center);
  for (const int r : find_rotors_on(model, support.name)) {
    const spatial::Placement& hub = placements[find_hub(support, r)];
    const spatial::MassProperties rotor =
        calc_rotor_mass(model, trees, r, !is_one_with_fuselage(model, trees, r));
    mass += rotor.mass;
    moment += rotor.mass * space::Position(hub.position) +
              space::Rotation{hub.rotation} * space::Position(rotor.first_moment);
  }
  for (std::size_t j = 0; j < support.bodies.size(); ++j) {
    if (support.bodies[j].is_hub()) continue;
    const spatial::MassProperties body =
        calc_mass_properties(support, support.bodies[j]).seen_from_outside(placements[j]);
    mass += body.mass;
    moment += space::Position(body.first_moment);
  }
  centre.from_base = moment / mass;
  for (int r = 0; r < count_rotors(model); ++r)
    if (is_one_with_fuselage(model, trees, r)) {
      const spatial::Placement hub = find_hub_placement(model, trees, r);
      centre.from_hubs[static_cast<std::size_t>(r)] =
          space::Rotation{hub.rotation}.inverse() *
          space::Position(centre.from_base - space::Position(hub.position));
    }
  return centre;
}

}  // namespace spoke
