// Calculates tip, energies and loads of a spatial subsystem at the state in the table.

#include "engine/kernels/samples.h"

#include <cassert>

#include "engine/kernels/kinematics.h"
#include "engine/kernels/loop_motion.h"
#include "engine/space/body_energies.h"
#include "engine/space/solid_places.h"
#include "engine/space/solid_table_terms.h"
#include "engine/space/table_terms.h"

namespace spoke {
namespace {

/// Returns the place of the outermost point of a body in its frame, deformed, less the
/// foreshortening [m].
space::Position find_tip(const BodyData<Space>& body) {
  if (const space::Solid* solid = body.model->body->solid())
    return calc_place_motion(solid->constants->tip, body.coordinates.q, body.coordinates.v).s;
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible) return body.model->body->rigid()->centre;
  space::Position tip = flexible->nodes.back();
  for (int c = 0; c < space::kPosition; ++c) {
    const int k = flexible->coordinate(flexible->elements, c);
    if (k >= 0) tip[c] += body.coordinates.q[k];
  }
  return tip;
}

/// Returns by how much the stiffening moves the place at which a body carries the next one, or its
/// tip, in its frame. `handle` 0: the tip.
space::Position draw(const BodyData<Space>& body, int handle) {
  const double *q = body.coordinates.q, *v = body.coordinates.v;
  if (const space::Solid* solid = body.model->body->solid()) {
    const int place = handle > 0 ? solid->handles[static_cast<std::size_t>(handle)]
                                 : solid->constants->tip_number;
    return calc_solid_drawn(body, place, q, v, nullptr).place;
  }
  if (!body.model->body->flexible()) return space::Position::Zero();
  return {-calc_foreshortening(body_model_of(body), q, body.work), 0.0, 0.0};
}

/// Returns the displacement of the tip from its undeformed place, hub frame [m].
space::Position calc_tip(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data) {
  assert(data.poses.size() == data.bodies.size() && !data.bodies.empty());
  const std::size_t last = data.bodies.size() - 1;
  space::Position tip =
      data.poses[last].p + data.poses[last].R * find_tip(data.bodies[last]) - subsystem.tip;
  // In bodies with geometric stiffening the energies account for this, not the coordinates.
  int handle = 0;
  for (int j = static_cast<int>(last); j >= 0; j = subsystem.bodies[j].parent) {
    const auto k = static_cast<std::size_t>(j);
    tip += data.poses[k].R * draw(data.bodies[k], handle);
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
  if (const space::RigidBody* rigid = body.model->body->rigid())
    return {calc_kinetic_energy(rigid_mass_of(body), twist), 0.0, 0.0, rigid->mass * rigid->centre};
  // The work of gravity that rises is that of a load. A hub that flies falls as its bodies do.
  const bool is_potential = system.gravity_ramp == 0.0 && system.hub.support == HubSupport::axle;
  const space::Position gravity =
      is_potential ? system.gravity : space::Position(space::Position::Zero());
  const space::BodyMotion motion{angular(twist), angular(hub.twist), hub.R.inverse() * gravity};
  if (body.model->body->solid())
    return calc_solid_energies(solid_model_of(body), body_state_of(body), twist, motion, body.work);
  return calc_body_energies(body_model_of(body), body_state_of(body), twist, motion, body.work);
}

/// Returns the energy of the springs and stops of the joint that carries a body [J].
double calc_springs(const SubsystemData<Space>& data, std::size_t j) {
  const BodyData<Space>& body = data.bodies[j];
  const space::TreeJoint& joint = body.model->joint;
  if (!joint.slide) return calc_spring_energy(joint.joint, joint_state_of(body));
  return calc_spring_energy(joint.joint, ShiftedJoint(body, calc_slide_shift(data, j)).state);
}

}  // namespace

SubsystemSample<Space> calc_sample(const System<Space>& system, std::size_t i,
                                   SubsystemData<Space>& data) noexcept {
  assert(i < system.subsystems.size());
  const Subsystem<Space>& subsystem = system.subsystems[i];
  calc_poses(subsystem, data, data.poses);
  SubsystemSample<Space> sample;
  sample.tip = calc_tip(subsystem, data);
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

}  // namespace spoke
