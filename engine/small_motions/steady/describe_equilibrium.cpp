// Reads tips, joints, loads and nodes of the subsystems.

#include "engine/small_motions/steady/describe_equilibrium.h"

#include <cassert>
#include <map>
#include <utility>

#include "engine/small_motions/steady/supported_model.h"
#include "engine/support/plain_zero.h"
#include "models/space/rotation_vector.h"

namespace spoke::steady {
namespace {

/// Describes a subsystem before it deforms, where its joints are in equilibrium.
BladeEquilibrium describe_undeformed(const SubsystemPart& part, const Eigen::VectorXd& q) {
  SteadyModel& model = *part.model;
  const std::size_t subsystem = part.subsystem;
  BladeEquilibrium described;
  described.name = model.name_of(subsystem);
  described.rotor = part.rotor;
  const std::vector<SubsystemCoordinate>& coordinates = model.coordinates(subsystem);
  Eigen::VectorXd rigid = q;
  const Eigen::VectorXd shown = model.absolute(subsystem, q);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const SubsystemCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    if (coordinate.node >= 0)
      rigid[k] = 0.0;
    else
      described.joints.push_back({coordinate.name, shown[k], coordinate.turns});
  }
  SubsystemResponse response;
  model.evaluate(subsystem, make_state(rigid), model.no_offset(), response);
  for (const NodePlace& place : model.places(subsystem)) {
    described.bodies.push_back(place.body);
    described.undeformed.push_back(place.p);
    described.undeformed_axes.push_back(place.axes);
  }
  described.solids = model.solids(subsystem);
  for (SolidDeformation& solid : described.solids)
    solid.coordinates = find_deformation(coordinates, solid.body, q);
  return described;
}

/// Adds what a subsystem shows in equilibrium, at which its model was left with its accelerations.
void add_equilibrium(const SubsystemPart& part, const Eigen::VectorXd& multipliers,
                     BladeEquilibrium& described) {
  SteadyModel& model = *part.model;
  const std::size_t subsystem = part.subsystem;
  for (const NodePlace& place : model.places(subsystem)) {
    const Eigen::Matrix3d& before = described.undeformed_axes[described.nodes.size()];
    described.nodes.push_back(place.p);
    described.rotations.emplace_back(
        space::logarithm(space::Rotation{place.axes * before.transpose()}));
  }
  const TipMotion tip = model.tip(subsystem);
  described.tip_displacement = tip.displacement;
  described.tip_rotation = tip.rotation;
  described.bending = model.bending(subsystem);
  if (const std::optional<SubsystemAir> air = model.air(subsystem))
    for (std::size_t k = 0; k < air->stations.size(); ++k) {
      const air::StationAir& s = air->stations[k];
      described.air.push_back({air->places[k], s.attack, s.relative_speed, s.axial_induction,
                               s.tangential_induction, s.lift, s.drag, s.moment, s.axial_force,
                               s.tangential_force, s.pitching_moment});
    }
  for (const RootLoad& load : model.root_loads(subsystem))
    described.loads.push_back({load.body, load.station, load.force, load.moment});
  described.loops = model.loop_loads(subsystem, multipliers);
}

/// Describes the parts of all subsystems, in the order of the scenario.
std::vector<BladeEquilibrium> describe_subsystems(const Equilibrium& found, SteadyModel& model) {
  std::map<std::size_t, BladeEquilibrium> by_number;
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::vector<SubsystemPart> members = model.members(i);
    for (const SubsystemPart& part : members)
      by_number[part.number] = describe_undeformed(part, part.part_of(found.q[i]));
    SubsystemResponse response;
    model.evaluate(i, make_state(found, i), model.no_offset(), response);
    model.accelerations(i);
    for (const SubsystemPart& part : members)
      add_equilibrium(part, part.forces_of(found.multipliers[i]), by_number[part.number]);
  }
  std::vector<BladeEquilibrium> list;
  for (auto& [number, own] : by_number) list.push_back(std::move(own));
  return list;
}

/// Adds what air does to a subsystem to what it does to its rotor.
void add(const SubsystemAir& air, std::optional<RotorAir>& rotor) {
  if (!rotor) rotor.emplace();
  rotor->wind = air.wind;
  rotor->thrust += air.thrust;
  rotor->torque += air.torque;
}

}  // namespace

EquilibriumResult describe(const Equilibrium& found, SteadyModel& model) {
  assert(found.q.size() == model.subsystems());
  EquilibriumResult result;
  result.speed = plain_zero(model.speed());
  result.iterations = found.iterations;
  result.load_steps = found.load_steps;
  result.last_change = found.last_change;
  result.blades = describe_subsystems(found, model);
  const std::vector<CarriedHub> hubs = model.carried_hubs(found.wrenches);
  const HubVector& wrench = hubs.empty() ? found.wrench : hubs.front().wrench;
  if (model.is_spatial()) {
    result.hub_force = wrench.head<3>();
    result.hub_moment = wrench.tail<3>();
  } else {
    result.hub_force.head<2>() = wrench.head<2>();
    result.hub_moment.z() = wrench[2];
  }
  if (!hubs.empty()) result.hub = HubPlace{hubs.front().place.p, hubs.front().place.axes};
  for (const CarriedHub& hub : hubs) {
    if (hubs.size() == 1) break;
    result.rotors.push_back({hub.name,
                             plain_zero(hub.speed),
                             {hub.place.p, hub.place.axes},
                             hub.wrench.head<3>(),
                             hub.wrench.tail<3>(),
                             std::nullopt});
  }
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    for (const SubsystemPart& part : model.members(i)) {
      const std::optional<SubsystemAir> air = part.model->air(part.subsystem);
      if (!air) continue;
      if (part.rotor == 0) add(*air, result.air);
      if (!result.rotors.empty())
        add(*air, result.rotors[static_cast<std::size_t>(part.rotor)].air);
    }
  return result;
}

}  // namespace spoke::steady
