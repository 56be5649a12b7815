// Calculates tip displacement and energies of a subsystem at the state in the table.

#include "engine/bodies/kernels/samples.h"

#include <cassert>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/plane/applied_tension.h"
#include "engine/bodies/kernels/plane/body_energies.h"
#include "engine/bodies/kernels/plane/handle_motion.h"

namespace spoke {

Twist calc_tip_displacement(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data) {
  assert(data.poses.size() == data.bodies.size());
  const Position undeformed = subsystem.root.p + subsystem.root.R * Position{subsystem.length, 0.0};
  Position tip =
      data.poses.back().p + data.poses.back().R * calc_outboard_position(data.bodies.back());
  double rotation = 0.0;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<Plane>& body = data.bodies[j];
    tip -= data.poses[j].R * Position{calc_foreshortening(body), 0.0};
    rotation += body.coordinates.q[body.outboard_at[kRotation]] -
                body.coordinates.q[body.inboard_at[kRotation]];
  }
  const Position displacement = tip - undeformed;
  return {displacement.x(), displacement.y(), rotation};
}

SubsystemSample<Plane> calc_sample(const System<Plane>& system, std::size_t i,
                                   SubsystemData<Plane>& data) noexcept {
  assert(i < system.subsystems.size());
  const Subsystem<Plane>& subsystem = system.subsystems[i];
  calc_poses(subsystem, data, data.poses);
  const Twist tip = calc_tip_displacement(subsystem, data);
  SubsystemSample<Plane> sample;
  sample.tip = {tip[0], tip[1]};
  sample.root = data.root_load;
  const HubState<Plane>& hub = *data.hub;
  if (!data.loops.is_empty()) sample.strain = calc_closure_energy(subsystem, data.loops);
  const bool has_gravity = system.gravity != Position::Zero() && system.gravity_ramp == 0.0;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const plane::BodyEnergies body =
        calc_body_energies(data.bodies[j], data.twists[j], hub.twist[kRotation]);
    sample.kinetic += body.kinetic;
    sample.strain += body.strain;
    if (!has_gravity) continue;
    const double mass = data.bodies[j].model->body->mass;
    const plane::Pose& X_HB = data.poses[j];
    Position moment = mass * X_HB.p + Position(X_HB.R * body.S);
    if (data.bodies[j].model->stiffening.outboard_mass && system.hub.support == HubSupport::axle)
      moment -= subsystem.root.R * Position{calc_foreshortened_moment(data.bodies[j]), 0.0};
    sample.gravity += system.gravity.dot(Position(mass * hub.p + Position(hub.R * moment)));
  }
  return sample;
}

void update_kinematics(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data) noexcept {
  calc_rotations(subsystem, data);
  calc_velocities(subsystem, data);
}

void keep_joint_loads(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data) noexcept {
  assert(data.joint_loads.size() == data.bodies.size());
  assert(data.wrenches.size() == data.bodies.size());
  for (std::size_t j = 0; j < data.bodies.size(); ++j)
    data.joint_loads[j] = data.wrenches[j].inboard;
  const plane::Rotation to_root = subsystem.root.R.inverse() * data.joints[0].R;
  data.root_load = Twist::Zero() - to_root * data.joint_loads[0];  // never -0
  if (!subsystem.bodies.front().stiffening.centrifugal) return;
  double inertia = 0.0, rate = 0.0, moment = 0.0;
  for (const BodyData<Plane>& body : data.bodies) {
    inertia += body.terms.stiffening.inertia;
    rate += body.terms.stiffening.rate;
    moment += body.terms.stiffening.moment;
  }
  data.root_load[kRotation] += inertia * (*data.hub_acceleration)[kRotation] +
                               2.0 * data.hub->twist[kRotation] * rate + moment;
}

PartList parts_of_joint_loads(const SubsystemData<Plane>& data) {
  PartList list{data.parts.wrenches, data.parts.rotations};
  if (data.bodies.front().model->stiffening)
    graph::add_to(list, data.parts.hub_acceleration, data.parts.hub_state,
                  data.parts.all(&BodyParts::terms));
  return list;
}

}  // namespace spoke
