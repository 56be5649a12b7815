#pragma once

// Helpers of the sources that add the nodes of a pass.

#include <algorithm>
#include <cassert>
#include <string_view>

#include "engine/step/formulation/tree_joints.h"
#include "engine/step/stages.h"
#include "engine/step/step_context.h"

namespace spoke {

/// The pass to which nodes are added, and the context of these.
template <class World>
struct Assembly : PassNodes {
  SystemContext<World>& c;

  /// Returns the parts of the system, and those of subsystem `i`.
  const SystemParts& parts() const { return c.data.parts; }
  const SubsystemParts& subsystem(int i) const { return c.data.subsystems[i].parts; }
};

/// Returns the label of a node of rotor `r`: of the first one the stage alone, of others with the
/// body that is the hub.
template <class World>
graph::NodeLabel label_of_rotor(const Assembly<World>& g, const Stage& stage, int r) {
  if (r == 0) return g.label(stage);
  const SupportedRotor& rotor = g.c.system.rotors[static_cast<std::size_t>(r)];
  return g.label(stage, rotor.subsystem, rotor.body);
}

/// Adds the nodes of the actors for subsystem `i` at this place of the pass.
template <class World>
void add_actors(const Assembly<World>& g, PassPlace place, int i) {
  for (const auto& actor : g.c.data.actors) actor->add_nodes(g, place, i);
}
/// Returns one member of all subsystems, and one of all bodies of all subsystems.
template <class World>
PartList all_of(const Assembly<World>& g, graph::PartId SubsystemParts::*member) {
  PartList list;
  for (const SubsystemData<World>& data : g.c.data.subsystems) list.push_back(data.parts.*member);
  return list;
}
template <class World>
PartList all_of(const Assembly<World>& g, graph::PartId BodyParts::*member) {
  PartList list;
  for (const SubsystemData<World>& data : g.c.data.subsystems)
    for (const BodyParts& body : data.parts.bodies) list.push_back(body.*member);
  return list;
}
/// Whether a body's joint has coordinates, whose accelerations then are among those of the body.
template <class World>
bool has_coordinates(const TreeBody<World>& body) {
  return joint_coordinates(body) > 0;
}
/// Returns the role of the nodes of a stage: of every pass, or of an actor. Precondition: there is
/// one of this name.
template <class World>
StageRole role_of(std::string_view stage, const StepData<World>& data) {
  if (const Stage* const found = stages::find(stage)) return found->role;
  const auto own = std::find_if(data.actors.begin(), data.actors.end(), [stage](const auto& actor) {
    return stage == actor->stage().name;
  });
  assert(own != data.actors.end());
  return (*own)->stage().role;
}
/// Whether a pass ends with the correction of a free coordinate of the hub.
template <class World>
bool corrects_hub(const Assembly<World>& g);

}  // namespace spoke
