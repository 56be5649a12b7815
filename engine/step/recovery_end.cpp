// Lists what a recovery reads and writes, and ends it.

#include "engine/step/recovery_end.h"

#include "engine/step/formulation/tree_joints.h"
#include "engine/step/pass_integration.h"

namespace spoke {

using graph::PartId;

template <class World>
void complete_recovery(const Method& method, int j, SubsystemData<World>& data) noexcept {
  report_drives(static_cast<std::size_t>(j), data);
  complete_body(method, data.progress->control, data.bodies[j]);
}

namespace {

/// Returns the parts on which the end of a recovery depends.
template <class World>
PartList parts_of_completed(const Method& method, std::size_t j, const SubsystemData<World>& data) {
  const SubsystemParts& own = data.parts;
  const BodyParts& body = own.bodies[j];
  PartList list{body.coordinates};  // checked, and corrected by generalized_alpha
  if (std::holds_alternative<GeneralizedAlpha>(method))
    graph::add_to(list, body.history, body.accelerations);
  if constexpr (tree::kHasJointCoordinates<World>) {
    const TreeBody<World>& model = *data.bodies[j].model;
    if (has_coordinates(model)) list.push_back(own.wrenches);  // accelerations are found with them
    if (has_coordinates(model) && std::holds_alternative<Rk4>(method))
      list.push_back(body.accelerations);
    if (model.joint.joint.driven > 0) graph::add_to(list, own.rotations, own.wrenches);
  }
  return list;
}

/// Returns the parts on which the accelerations of a body depend, by formulation.
template <class World>
PartList parts_of_accelerations(const Assembly<World>& g, std::size_t i, std::size_t j) {
  const SubsystemData<World>& data = g.c.data.subsystems[i];
  switch (g.c.formulation) {
    case Formulation::structured:
      return structured::parts_of_recovered(j, data);
    case Formulation::subsystem:
      return subsystem::parts_of_recovered(j, data);
    case Formulation::augmented:
      break;
  }
  return {g.parts().augmented_solution};
}

}  // namespace

template <class World>
RecoveryAccess recovery_access(const Assembly<World>& g, int i, int j) {
  const auto index = static_cast<std::size_t>(j);
  const SubsystemData<World>& data = g.c.data.subsystems[i];
  const BodyParts& body = data.parts.bodies[index];
  PartList inputs{data.parts.progress};
  graph::add_to(inputs, parts_of_accelerations(g, static_cast<std::size_t>(i), index),
                parts_of_completed(g.c.integrator.method, index, data));
  PartList outputs{body.accelerations, body.report};
  graph::add_to(outputs, graph::maybe(body.found));
  if (tree::kHasJointCoordinates<World> && g.c.formulation == Formulation::structured)
    outputs.push_back(body.scratch);
  if (std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method))
    outputs.push_back(body.coordinates);
  graph::add_to(outputs, body.solution);  // a solid in one slice does all here
  return {inputs, outputs};
}

template <class World>
RecoveryAccess completion_access(const Assembly<World>& g, int i, int j) {
  RecoveryAccess access = recovery_access(g, i, j);
  const std::vector<PartId>& solution = g.subsystem(i).bodies[j].solution;
  access.outputs.resize(access.outputs.size() - solution.size());
  access.inputs.push_back(g.subsystem(i).bodies[j].accelerations);
  return access;
}

template RecoveryAccess recovery_access(const Assembly<Plane>&, int, int);
template RecoveryAccess recovery_access(const Assembly<Space>&, int, int);
template RecoveryAccess completion_access(const Assembly<Space>&, int, int);
template void complete_recovery(const Method&, int, SubsystemData<Plane>&) noexcept;
template void complete_recovery(const Method&, int, SubsystemData<Space>&) noexcept;

}  // namespace spoke
