// Calculates tip, energies and loads of a spatial subsystem at the state in the table.

#include "engine/bodies/kernels/samples.h"

#include <cassert>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/bodies/space/body_energies.h"
#include "engine/bodies/table/body_kind.h"
#include "models/system/tip_body.h"

namespace spoke {
namespace {

/// Returns the displacement of the tip, which is on body `last`, from its undeformed place, hub
/// frame [m].
space::Position calc_tip(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                         std::size_t last) {
  assert(data.poses.size() == data.bodies.size() && last < data.bodies.size());
  space::Position tip = data.poses[last].p +
                        data.poses[last].R * data.bodies[last].kind->find_tip(data.bodies[last]) -
                        subsystem.tip;
  // In bodies with geometric stiffening the energies account for this, not the coordinates.
  int handle = 0;
  for (int j = static_cast<int>(last); j >= 0; j = subsystem.bodies[j].parent) {
    const auto k = static_cast<std::size_t>(j);
    tip += data.poses[k].R * data.bodies[k].kind->calc_shown_drawn(data.bodies[k], handle);
    handle = subsystem.bodies[j].handle;
  }
  return tip;
}

/// Returns the energies of a body, and its first moment in its frame.
space::BodyEnergies calc_energies(const System<Space>& system, const SubsystemData<Space>& data,
                                  std::size_t j) {
  const BodyData<Space>& body = data.bodies[j];
  const space::Twist& twist = data.twists[j];
  const HubState<Space>& hub = *data.hub;
  // The work of gravity that rises is that of a load. A hub that flies falls as its bodies do.
  const bool is_potential = system.gravity_ramp == 0.0 && system.hub.support == HubSupport::axle;
  const space::Position gravity =
      is_potential ? system.gravity : space::Position(space::Position::Zero());
  const space::BodyMotion motion{angular(twist), angular(hub.twist), hub.R.inverse() * gravity};
  return body.kind->calc_energies(body, twist, motion);
}

/// Returns the energy of the springs and stops of the joint that carries a body, and that of what
/// actors add to it [J].
double calc_springs(const SubsystemData<Space>& data, std::size_t j) {
  const BodyData<Space>& body = data.bodies[j];
  const space::TreeJoint& joint = body.model->joint;
  double sum = joint.slide ? calc_spring_energy(joint.joint,
                                                ShiftedJoint(body, calc_slide_shift(data, j)).state)
                           : calc_spring_energy(joint.joint, joint_state_of(body));
  for (const space::AddedEffort& added : body.joint.added) sum += added.effort->energy;
  return sum;
}

}  // namespace

SubsystemSample<Space> calc_sample(const System<Space>& system, std::size_t i,
                                   SubsystemData<Space>& data) noexcept {
  assert(i < system.subsystems.size());
  const Subsystem<Space>& subsystem = system.subsystems[i];
  calc_poses(subsystem, data, data.poses);
  SubsystemSample<Space> sample;
  sample.tip = calc_tip(subsystem, data, find_tip_body(system, i));
  sample.root = data.root_load;
  if (!data.loops.is_empty()) sample.strain = calc_closure_energy(subsystem, data.loops);
  const HubState<Space>& hub = *data.hub;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<Space>& body = data.bodies[j];
    const space::BodyEnergies energies = calc_energies(system, data, j);
    sample.kinetic += energies.kinetic;
    sample.strain += energies.strain + energies.tension + calc_springs(data, j);
    if (system.gravity_ramp > 0.0) continue;
    const double mass = body.model->body->mass();
    const space::Position moment = mass * data.poses[j].p + data.poses[j].R * energies.S;
    sample.gravity += system.gravity.dot(mass * hub.p + hub.R * moment);
  }
  return sample;
}

void update_kinematics(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept {
  calc_rotations(subsystem, data);
  calc_velocities(subsystem, data);
}

void keep_joint_loads(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept {
  assert(data.joint_loads.size() == data.bodies.size());
  assert(data.wrenches.size() == data.bodies.size());
  for (std::size_t j = 0; j < data.bodies.size(); ++j)
    data.joint_loads[j] = data.wrenches[j].inboard;
  data.root_load = -(data.joints[0].R * data.wrenches[0].inboard);
  // The loads of further bodies on the hub are taken about the origin of the first.
  for (std::size_t j = 1; j < data.bodies.size(); ++j) {
    if (subsystem.bodies[j].parent >= 0) continue;
    const space::JointMotion& joint = data.joints[j];
    const space::Position from_first = joint.p - data.joints[0].p;
    data.root_load -= translate(from_first, joint.R * data.wrenches[j].inboard);
  }
}

PartList parts_of_joint_loads(const SubsystemData<Space>& data) {
  return {data.parts.wrenches, data.parts.rotations};
}

}  // namespace spoke
