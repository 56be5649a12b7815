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

void evaluate(std::size_t subsystem, const Eigen::VectorXd& q, SteadyModel& model) {
  SubsystemResponse response;
  model.evaluate(subsystem, make_state(q), model.no_offset(), response);
}

/// Describes a subsystem by its own part of the equilibrium. Precondition: what loops tie it to was
/// evaluated there.
BladeEquilibrium describe_subsystem(const SubsystemPart& part, const Eigen::VectorXd& q,
                                    const Eigen::VectorXd& multipliers) {
  SteadyModel& model = *part.model;
  const std::size_t subsystem = part.subsystem;
  BladeEquilibrium described;
  described.name = model.name_of(subsystem);
  const std::vector<SubsystemCoordinate>& coordinates = model.coordinates(subsystem);
  Eigen::VectorXd rigid = q;  // joints as they are, bodies undeformed
  const Eigen::VectorXd shown = model.absolute(subsystem, q);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const SubsystemCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    if (coordinate.node >= 0)
      rigid[k] = 0.0;
    else
      described.joints.push_back({coordinate.name, shown[k], coordinate.turns});
  }
  evaluate(subsystem, rigid, model);
  for (const NodePlace& place : model.places(subsystem)) {
    described.bodies.push_back(place.body);
    described.undeformed.push_back(place.p);
    described.undeformed_axes.push_back(place.axes);
  }
  described.solids = model.solids(subsystem);
  for (SolidDeformation& solid : described.solids)
    solid.coordinates = find_deformation(coordinates, solid.body, q);
  evaluate(subsystem, q, model);
  for (const NodePlace& place : model.places(subsystem)) {
    const Eigen::Matrix3d& before = described.undeformed_axes[described.nodes.size()];
    described.nodes.push_back(place.p);
    described.rotations.emplace_back(
        space::logarithm(space::Rotation{place.axes * before.transpose()}));
  }
  model.accelerations(subsystem);
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
  return described;
}

/// Describes the parts of all subsystems, in the order of the scenario.
std::vector<BladeEquilibrium> describe_subsystems(const Equilibrium& found, SteadyModel& model) {
  std::map<std::size_t, BladeEquilibrium> by_number;
  const SupportedModel* machine = model.on_support();
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    for (const SubsystemPart& part : model.members(i)) {
      SubsystemResponse response;
      model.evaluate(i, make_state(found, i), model.no_offset(), response);
      BladeEquilibrium& own = by_number[part.number] =
          describe_subsystem(part, part.part_of(found.q[i]), part.forces_of(found.multipliers[i]));
      if (machine && !model.stands(i)) own.rotor = static_cast<int>(machine->rotor_of(i));
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

HubPlace place_hub(std::size_t r, const SupportedModel& machine) {
  const NodePlace hub = machine.hub_place(r);
  return {hub.p, hub.axes};
}

std::vector<RotorEquilibrium> describe_rotors(const Equilibrium& found,
                                              const SupportedModel& machine) {
  std::vector<RotorEquilibrium> rotors;
  for (std::size_t r = 0; r < machine.rotors(); ++r) {
    const RotorParts& parts = machine.parts(r);
    const HubVector& wrench = found.wrenches[r];
    rotors.push_back({parts.name, plain_zero(parts.speed), place_hub(r, machine), wrench.head<3>(),
                      wrench.tail<3>(), std::nullopt});
  }
  return rotors;
}

}  // namespace

EquilibriumResult describe(const Equilibrium& found, SteadyModel& model) {
  assert(found.q.size() == model.subsystems());
  EquilibriumResult result;
  result.speed = plain_zero(model.speed());
  result.iterations = found.iterations;
  result.load_steps = found.load_steps;
  result.last_change = found.last_change;
  if (model.is_spatial()) {
    result.hub_force = found.wrench.head<3>();
    result.hub_moment = found.wrench.tail<3>();
  } else {
    result.hub_force.head<2>() = found.wrench.head<2>();
    result.hub_moment.z() = found.wrench[2];
  }
  const SupportedModel* machine = model.on_support();
  if (machine && machine->rotors() > 1) result.rotors = describe_rotors(found, *machine);
  result.blades = describe_subsystems(found, model);
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const std::optional<SubsystemAir> air = model.air(i);
    if (!air) continue;
    const std::size_t rotor = machine && !model.stands(i) ? machine->rotor_of(i) : 0;
    if (rotor == 0) add(*air, result.air);
    if (!result.rotors.empty()) add(*air, result.rotors[rotor].air);
  }
  if (machine) result.hub = place_hub(0, *machine);
  return result;
}

}  // namespace spoke::steady
