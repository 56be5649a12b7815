// Sums the forces that are applied to the bodies of a tree in space, and passes those of sliding
// joints on.

#include "engine/bodies/kernels/applied_forces.h"

#include "engine/bodies/kernels/space/table_terms.h"

namespace spoke {
namespace {

/// Finds the true place of the slide of the joint that carries body `j`, and the force on it.
void find_slide(double t, std::size_t j, SubsystemData<Space>& data) {
  BodyData<Space>& body = data.bodies[j];
  const space::TreeJoint& model = body.model->joint;
  const auto c = static_cast<std::size_t>(model.slide->coordinate);
  const std::array<double, space::Joint::kMost> motor = calc_motors(model, t);
  body.slide = calc_slide_shift(data, j);
  const ShiftedJoint shifted(body, body.slide);
  space::JointForces there, here;
  calc_joint_forces(model.joint, shifted.state, {}, nullptr, motor.data(), there);
  calc_joint_forces(model.joint, joint_state_of(body), {}, nullptr, motor.data(), here);
  body.slide.force = there.tau[c];
  for (const space::AddedEffort& added : body.joint.added)
    if (added.coordinate == model.slide->coordinate) body.slide.force += added.effort->force;
  body.slide.change = there.tau[c] - here.tau[c];
}

/// Returns the force that a body passes to the one that carries it; along a slide n with
/// the force tau that is F - (n.F) n - tau n of its sum F.
space::Position pass_inward(const BodyData<Space>& body, const space::Position& sum) {
  const auto& slide = body.model->joint.slide;
  if (!slide) return sum;
  return sum - (slide->axis.dot(sum) + body.slide.force) * slide->axis;
}

}  // namespace

void calc_applied_forces(const System<Space>& system, std::size_t i, double t,
                         StepData<Space>& table) noexcept {
  const Subsystem<Space>& subsystem = system.subsystems[i];
  SubsystemData<Space>& data = table.subsystems[i];
  ArenaVector<space::Position>& sums = data.applied_forces;
  space::Position whole = space::Position::Zero();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    sums[j] = sum_forces(t, subsystem, data, j);
    whole += sums[j];
    if (has_slide(*data.bodies[j].model)) find_slide(t, j, data);
  }
  for (std::size_t j = data.bodies.size(); j-- > 0;)
    for (const int child : data.bodies[j].model->children) {
      const auto c = static_cast<std::size_t>(child);
      sums[c] = pass_inward(data.bodies[c], sums[c]);
      sums[j] += sums[c];
    }
  sums.back() = whole;
}

PartList parts_of_applied_forces(std::size_t i, const StepData<Space>& table) {
  const SubsystemData<Space>& data = table.subsystems[i];
  PartList list;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    graph::add_to(list, loads_on(i, j, table), parts_of_forces(j, data));
    if (has_slide(*data.bodies[j].model)) graph::add_to(list, parts_of_slide(j, data));
  }
  return list;
}

}  // namespace spoke
