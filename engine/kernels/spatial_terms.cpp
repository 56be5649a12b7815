// Hands the table's data to the kernels of spatial bodies and joints.

#include "engine/kernels/spatial_terms.h"

#include <array>

#include "engine/space/body_energies.h"
#include "engine/space/body_terms.h"

namespace spoke {
namespace {

using space::BodyTerms;

BodyTerms calc_rigid_terms(const space::RigidBody& body, const space::Twist& twist) {
  const space::SymmetricTwistMatrix mass = calc_mass(body);
  BodyTerms terms;
  terms.S = body.mass * body.centre;
  terms.Theta = mass.rr;
  terms.Q = calc_gyroscopic_force(mass, twist);
  return terms;
}

space::Rotation rotation_to_hub(const SubsystemData<Space>& data, int j) {
  space::Rotation R = data.joints[j].R;
  for (j = data.bodies[j].model->parent; j >= 0; j = data.bodies[j].model->parent)
    R = data.joints[j].R * R;
  return R;
}

/// Of gravity that rises, whose work is that of a load.
void add_gravity_power(const space::Position& gravity_H, const SubsystemData<Space>& data, int j,
                       BodyData<Space>& body) {
  const space::Twist& twist = data.twists[j];
  const space::Position gravity = rotation_to_hub(data, j).inverse() * gravity_H;
  if (const space::RigidBody* rigid = body.model->body->rigid()) {
    body.terms.load_power += gravity.dot(space::Position(linear(calc_mass(*rigid) * twist)));
    return;
  }
  const space::BodyMotion motion{angular(twist), angular(data.hub->twist), gravity_H};
  body.terms.load_power += calc_gravity_power(body_model_of(body), body_state_of(body), twist,
                                              motion, gravity, body.work);
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

space::JointState joint_state_of(const BodyData<Space>& body) {
  return {body.joint.coordinates.q, body.joint.coordinates.v, &body.joint.rotation->reference,
          body.joint.driven};
}

void calc_terms(const System<Space>& system, double t, const space::ImplicitShares& shares, int j,
                SubsystemData<Space>& data) noexcept {
  BodyData<Space>& body = data.bodies[j];
  const space::Twist& twist = data.twists[j];
  if (const space::RigidBody* rigid = body.model->body->rigid()) {
    body.terms = calc_rigid_terms(*rigid, twist);
  } else {
    const HubState<Space>& hub = *data.hub;
    const space::BodyMotion motion{angular(twist), angular(hub.twist),
                                   hub.R.inverse() * space::Position(system.gravity_at(t))};
    body.terms = calc_body_terms(body_model_of(body), body_state_of(body), motion, system.damping,
                                 body.work);
  }
  if (system.gravity_ramp > 0.0)
    add_gravity_power(data.hub->R.inverse() * space::Position(system.gravity_at(t)), data, j, body);
  add_joint_forces(t, shares, body);
}

}  // namespace spoke
