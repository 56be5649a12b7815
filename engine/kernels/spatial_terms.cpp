// Hands the table's data to the kernels of spatial bodies and joints.

#include "engine/kernels/spatial_terms.h"

#include <array>

#include "engine/kernels/kinematics.h"
#include "engine/space/body_energies.h"
#include "engine/space/body_terms.h"

namespace spoke {
namespace {

using space::BodyTerms;

BodyTerms calc_rigid_terms(const space::RigidBody& body, const space::SymmetricTwistMatrix& mass,
                           const space::Twist& twist) {
  BodyTerms terms;
  terms.S = body.mass * body.centre;
  terms.Theta = mass.rr();
  terms.Q = calc_gyroscopic_force(mass, twist);
  return terms;
}

/// Springs, dampers, stops and motors.
void add_joint_forces(double t, const space::ImplicitShares& shares, BodyData<Space>& body) {
  const space::TreeJoint& model = body.model->joint;
  const int n = model.joint.coordinates;
  if (n == 0) return;
  std::array<double, space::Joint::kMost> motor{};
  for (std::size_t c = 0; c < model.course.efforts.size(); ++c)
    motor[c] = model.course.efforts[c].value(t);
  const space::JointState state = joint_state_of(body);
  calc_joint_forces(model.joint, state, shares, body.joint.coordinates.a, motor.data(),
                    *body.joint.forces);
  for (int c = 0; c < n; ++c)
    body.terms.load_power += motor[static_cast<std::size_t>(c)] * state.v[c];
  body.terms.dissipation += calc_dissipation(model.joint, state);
}

/// From the frame in which a load is resolved to B.
space::Rotation resolve(spatial::LoadFrame frame, const space::Rotation& R_HB,
                        const space::Rotation& R_0, const space::Rotation& section) {
  switch (frame) {
    case spatial::LoadFrame::inertial:
      return (R_0 * R_HB).inverse();
    case spatial::LoadFrame::hub:
      return R_HB.inverse();
    case spatial::LoadFrame::body:
      return {};
    case spatial::LoadFrame::section:
      break;
  }
  return section;
}

/// Adds a wrench in B, and its power.
void add_wrench(const space::Section& section, const space::HandleMotion& motion,
                const space::Twist& wrench, const space::Twist& twist, BodyData<Space>& body) {
  if (body.model->body->flexible())
    add_section_wrench(section, motion, wrench, body.terms, body.work);
  else
    body.terms.Q += translate(motion.s, wrench);
  body.terms.load_power += wrench.dot(motion.carry(twist) + motion.twist());
}

void add_loads(double t, const space::Rotation& R_HB, const space::Rotation& R_0,
               const space::Twist& twist, BodyData<Space>& body) {
  for (const auto& [load, sections] : body.loads)
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const space::HandleMotion motion = motion_at(body, sections[k]);
      const space::Twist wrench =
          calc_load_wrench(*load, k, t, R_HB, R_0, motion.turn.R * sections[k].axes);
      add_wrench(sections[k], motion, wrench, twist, body);
    }
}

/// What loads of the user's exert.
void add_applied(const space::Twist& twist, BodyData<Space>& body) {
  for (const auto& [section, wrench] : body.applied)
    add_wrench(*section, motion_at(body, *section), make_wrench(wrench->force, wrench->moment),
               twist, body);
}

/// Of gravity that rises, whose work is that of a load.
void add_gravity_power(const space::Position& gravity_H, const space::Rotation& R_HB,
                       const HubState<Space>& hub, const space::Twist& twist,
                       BodyData<Space>& body) {
  const space::Position gravity = R_HB.inverse() * gravity_H;
  if (body.model->body->rigid()) {
    body.terms.load_power += gravity.dot(space::Position(linear(rigid_mass_of(body) * twist)));
    return;
  }
  const space::BodyMotion motion{angular(twist), angular(hub.twist), gravity_H};
  body.terms.load_power += calc_gravity_power(body_model_of(body), body_state_of(body), twist,
                                              motion, gravity, body.work);
}

}  // namespace

space::BodyModel body_model_of(const BodyData<Space>& body) {
  const space::FlexibleBody* flexible = body.model->body->flexible();
  const auto& tension = body.model->stiffening;
  return {flexible,
          {&*body.blocks[0]->elastic, &*body.blocks[1]->elastic},
          tension ? &*tension : nullptr};
}

space::BodyState body_state_of(const BodyData<Space>& body) {
  return {body.coordinates.q, body.coordinates.v, body.q_elastic, body.v_elastic};
}

const space::SymmetricTwistMatrix& rigid_mass_of(const BodyData<Space>& body) {
  return body.blocks[0]->rigid->mass;
}

space::Twist calc_load_wrench(const BodyLoad<Space>& load, std::size_t k, double t,
                              const space::Rotation& R_HB, const space::Rotation& R_0,
                              const space::Rotation& section) noexcept {
  const double size = load.course->value(t) * load.points[k].weight;
  const space::Rotation R = resolve(load.frame, R_HB, R_0, section);
  return size * (R * make_wrench(load.force, load.moment));
}

space::HandleMotion motion_at(const BodyData<Space>& body, const space::Section& section) noexcept {
  if (const space::FlexibleBody* flexible = body.model->body->flexible())
    return calc_section_motion(*flexible, section, body.coordinates.q, body.coordinates.v);
  return space::make_fixed_handle(section.s0);
}

space::JointState joint_state_of(const BodyData<Space>& body) {
  return {body.joint.coordinates.q, body.joint.coordinates.v, &body.joint.rotation->reference,
          body.joint.driven};
}

void calc_terms(const System<Space>& system, const Subsystem<Space>& subsystem, double t,
                const space::ImplicitShares& shares, int j, SubsystemData<Space>& data) noexcept {
  BodyData<Space>& body = data.bodies[j];
  const space::Twist& twist = data.twists[j];
  if (const space::RigidBody* rigid = body.model->body->rigid()) {
    body.terms = calc_rigid_terms(*rigid, rigid_mass_of(body), twist);
  } else {
    const HubState<Space>& hub = *data.hub;
    const space::BodyMotion motion{angular(twist), angular(hub.twist),
                                   hub.R.inverse() * space::Position(system.gravity_at(t))};
    body.terms = calc_body_terms(body_model_of(body), body_state_of(body), motion, system.damping,
                                 body.work);
  }
  add_joint_forces(t, shares, body);
  add_applied(twist, body);
  if (body.loads.empty() && system.gravity_ramp == 0.0) return;
  const space::Rotation R_HB = calc_rotation_to_hub(subsystem, data, j);
  add_loads(t, R_HB, data.hub->R, twist, body);
  if (system.gravity_ramp > 0.0)
    add_gravity_power(data.hub->R.inverse() * space::Position(system.gravity_at(t)), R_HB,
                      *data.hub, twist, body);
}

}  // namespace spoke
