// Lists what a recovery reads and writes, and ends it.

#include "engine/step/recovery_end.h"

#include "engine/step/formulation/tree_joints.h"
#include "engine/step/pass_integration.h"

namespace spoke {

using graph::PartId;

template <class World>
RecoveryAccess recovery_access(const Assembly<World>& g, int i, int j) {
  const SubsystemParts& own = g.subsystem(i);
  const BodyParts& body = own.bodies[j];
  PartList inputs{own.progress, body.coordinates};  // checked, and corrected by generalized_alpha
  PartList outputs{body.accelerations, body.report};
  graph::add_to(outputs, graph::maybe(body.found));
  if (g.c.formulation == Formulation::augmented) {
    inputs.push_back(g.parts().augmented_solution);
  } else {
    inputs.push_back(own.wrenches);
    inputs.push_back(body.inverse);
    if (g.c.formulation == Formulation::structured)
      graph::add_to(inputs, graph::maybe(body.tension), graph::maybe(body.carried));
  }
  if constexpr (tree::kHasJointCoordinates<World>) {
    const TreeBody<World>& model = g.c.system.subsystems[i].bodies[j];
    if (g.c.formulation == Formulation::structured) {
      for (const PartId part : {own.rotations, body.terms, body.scratch}) inputs.push_back(part);
      outputs.push_back(body.scratch);
    }
    if (has_coordinates(model))
      inputs.push_back(own.wrenches);  // its accelerations are found with them
    if (model.joint.joint.driven > 0)
      for (const PartId part : {own.rotations, own.wrenches}) inputs.push_back(part);
    if (std::holds_alternative<Rk4>(g.c.integrator.method) && has_coordinates(model))
      inputs.push_back(body.accelerations);
  }
  if (std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method)) {
    inputs.push_back(body.history);
    inputs.push_back(body.accelerations);
    outputs.push_back(body.coordinates);
  }
  // A solid in one slice does all here.
  graph::add_to(inputs, body.halves);
  graph::add_to(outputs, body.solution);
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

template <class World>
void complete_recovery(const Method& method, int j, SubsystemData<World>& data) noexcept {
  report_drives(static_cast<std::size_t>(j), data);
  complete_body(method, data.progress->control, data.bodies[j]);
}

template RecoveryAccess recovery_access(const Assembly<Plane>&, int, int);
template RecoveryAccess recovery_access(const Assembly<Space>&, int, int);
template RecoveryAccess completion_access(const Assembly<Space>&, int, int);
template void complete_recovery(const Method&, int, SubsystemData<Plane>&) noexcept;
template void complete_recovery(const Method&, int, SubsystemData<Space>&) noexcept;

}  // namespace spoke
