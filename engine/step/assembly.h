#pragma once

// Helpers of the sources that add the nodes of a pass.

#include <string>
#include <vector>

#include "engine/formulation/tree_joints.h"
#include "engine/step/stages.h"
#include "engine/step/step_context.h"
#include "graph/step_graph.h"

namespace spoke {

using PartList = std::vector<graph::PartId>;

/// The builder of a graph, the context of its nodes, and the pass that they belong to.
template <class World>
struct Assembly {
  SystemContext<World>& c;
  graph::StepGraphBuilder& builder;
  int pass = -1;

  /// Returns the parts of the system, and those of subsystem `i`.
  const SystemParts& parts() const { return c.data.parts; }
  const SubsystemParts& subsystem(int i) const { return c.data.subsystems[i].parts; }
  graph::NodeLabel label(const char* stage, int subsystem = -1, int body = -1) const {
    return {stage, subsystem, body, pass};
  }
  graph::NodeLabel label_item(const char* stage, int subsystem, const std::string& item) const {
    return {stage, subsystem, -1, pass, item};
  }
};

/// Makes the body of a node that has nothing to do while its progress is halted.
template <class Body>
auto unless_halted(const StepProgress& progress, Body body) {
  return [&progress, body]() noexcept {
    if (!progress.is_halted) body();
  };
}

/// Returns the rotor whose support subsystem `i` is; -1: none.
template <class World>
int find_supported(const Assembly<World>& g, int i) {
  for (std::size_t r = 0; r < g.c.system.rotors.size(); ++r)
    if (g.c.system.rotors[r].subsystem == i) return static_cast<int>(r);
  return -1;
}
/// Returns the rotor whose hub body `j` of subsystem `i` is; -1: none.
template <class World>
int find_hub(const Assembly<World>& g, int i, int j) {
  const int r = find_supported(g, i);
  return r >= 0 && g.c.system.rotors[static_cast<std::size_t>(r)].body == j ? r : -1;
}

/// Returns the parts of the user's loads, and of air, that act on body `j` of subsystem `i`.
template <class World>
PartList loads_on(const Assembly<World>& g, int i, int j);
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
/// Whether a pass ends with the correction of a free coordinate of the hub.
template <class World>
bool corrects_hub(const Assembly<World>& g);

}  // namespace spoke
