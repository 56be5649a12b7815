// Hands the table's data to the kernels of spatial bodies and joints.

#include "engine/bodies/kernels/space/table_terms.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/table/body_kind.h"
#include "models/space/mount.h"

namespace spoke {
namespace {

/// Sets the forces of springs, dampers, stops and motors, and adds their power.
void add_joint_forces(double t, const space::ImplicitShares& shares, BodyData<Space>& body) {
  const space::TreeJoint& model = body.model->joint;
  const int n = model.joint.coordinates;
  if (n == 0) return;
  const space::JointState state = joint_state_of(body);
  std::array<double, space::Joint::kMost> motor = calc_motors(model, t);
  if (model.course.drive) {
    const double ratio = model.course.drive_ratio;
    motor[0] += calc_torque(*model.course.drive, t, state.v[0] / ratio) / ratio;
  }
  calc_joint_forces(model.joint, state, shares, body.joint.coordinates.a, motor.data(),
                    *body.joint.forces);
  for (int c = 0; c < n; ++c)
    body.terms.load_power += motor[static_cast<std::size_t>(c)] * state.v[c];
  if (!model.slide) {
    body.terms.dissipation += calc_dissipation(model.joint, state);
    return;
  }
  const space::SlideState& slide = body.slide;
  const auto c = static_cast<std::size_t>(model.slide->coordinate);
  body.joint.forces->tau[c] += slide.change;
  // The whole force does work on the bodies inboard by the shift; only the motor's is that of a
  // load.
  body.terms.load_power += (motor[c] - slide.force) * slide.rate;
  body.terms.dissipation += calc_dissipation(model.joint, ShiftedJoint(body, slide).state);
}

/// Adds what actors do to the joint, as far as its coordinates go.
void add_efforts(const space::ImplicitShares& shares, BodyData<Space>& body) {
  for (const space::AddedEffort& added : body.joint.added) {
    space::JointForces& forces = *body.joint.forces;
    const auto c = static_cast<std::size_t>(added.coordinate);
    const double share = shares.stiffness * added.effort->stiffness;
    forces.tau[c] += added.effort->force;
    if (share != 0.0) forces.tau[c] += share * body.joint.coordinates.a[c];
    forces.share[c] += share;
    body.terms.dissipation += added.effort->dissipation;
  }
}

/// Whether what is applied to a body is resolved in other frames than its own.
bool is_resolved(const BodyData<Space>& body) {
  return !body.loads.empty() || (has_applied_tension(body) && !body.applied.empty());
}

bool is_any_in(spatial::LoadFrame frame, const std::vector<BodyLoad<Space>>& loads) {
  return std::any_of(loads.begin(), loads.end(),
                     [frame](const BodyLoad<Space>& load) { return load.frame == frame; });
}

bool has_working_field(const System<Space>& system, const SubsystemData<Space>& data) {
  return system.hub.mount || data.flight_acceleration || data.moved_acceleration;
}

/// Returns the field that tension feels without gravity of constant size, whose work is a function
/// of the state; in H.
space::Position calc_working_field(const System<Space>& system, double t,
                                   const SubsystemData<Space>& data) {
  space::Position field = calc_tension_field(system, t, data);
  if (system.hub.support == HubSupport::free) return field;
  return field - data.hub->R.inverse() * space::Position(system.gravity_at(t));
}

/// Adds the power of gravity that rises, whose work is that of a load; `tension_H`: the part of it
/// that the tension feels.
void add_gravity_power(const space::Position& gravity_H, const space::Position& tension_H,
                       const space::Rotation& R_HB, const HubState<Space>& hub,
                       const space::Twist& twist, BodyData<Space>& body) {
  const space::Position gravity = R_HB.inverse() * gravity_H;
  body.terms.load_power += gravity.dot(body.kind->calc_linear_momentum(body, twist)) +
                           calc_tension_power(body.terms.tension, angular(hub.twist), tension_H);
}

}  // namespace

bool has_implicit_tension(const BodyData<Space>& body) noexcept {
  return body.tension && body.tension->is_on();
}

bool has_applied_tension(const BodyData<Space>& body) noexcept {
  return body.model->stiffening && body.forces;
}

space::Position calc_deformed_momentum(const BodyData<Space>& body,
                                       const space::Twist& twist) noexcept {
  const space::BodyTerms& terms = body.terms;
  return body.model->body->mass() * linear(twist) + cross(angular(twist), terms.S) + terms.S_rate;
}

bool depend_on_pose(const BodyData<Space>& body) noexcept {
  const std::vector<BodyLoad<Space>>& loads = body.model->loads;
  return !body.applied.empty() || is_any_in(spatial::LoadFrame::body, loads) ||
         is_any_in(spatial::LoadFrame::section, loads);
}

space::Position sum_forces(double t, const Subsystem<Space>& subsystem,
                           const SubsystemData<Space>& data, std::size_t j) noexcept {
  assert(j < data.bodies.size());
  space::Position sum = space::Position::Zero();
  const BodyData<Space>& body = data.bodies[j];
  if (!body.forces.applied) return sum;
  space::Rotation R_HB;
  if (depend_on_pose(body)) R_HB = calc_rotation_to_hub(subsystem, data, static_cast<int>(j));
  sum += body.kind->sum_loads(t, R_HB, data.hub->R, body);
  for (const AppliedWrench<Space>& at : body.applied) sum += at.wrench->force;
  return R_HB * sum;
}

PartList parts_of_forces(std::size_t j, const SubsystemData<Space>& data) {
  const BodyData<Space>& body = data.bodies[j];
  const std::vector<BodyLoad<Space>>& loads = body.model->loads;
  PartList list;
  if (depend_on_pose(body)) {
    list.push_back(data.parts.rotations);
    if (!loads.empty()) list.push_back(data.parts.bodies[j].coordinates);
  }
  if (is_any_in(spatial::LoadFrame::inertial, loads)) list.push_back(data.parts.hub_state);
  return list;
}

std::array<double, space::Joint::kMost> calc_motors(const space::TreeJoint& joint,
                                                    double t) noexcept {
  assert(joint.course.efforts.size() <= space::Joint::kMost);
  std::array<double, space::Joint::kMost> motor{};
  for (std::size_t c = 0; c < joint.course.efforts.size(); ++c)
    motor[c] = joint.course.efforts[c].value(t) + joint.course.added[c];
  return motor;
}

space::SlideState calc_slide_shift(const SubsystemData<Space>& data, std::size_t j) noexcept {
  assert(j < data.bodies.size() && data.bodies[j].model->joint.slide);
  space::SlideState slide;
  const TreeBody<Space>* outer = data.bodies[j].model;
  const space::Position& axis = outer->joint.slide->axis;
  while (outer->parent >= 0) {
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(outer->parent)];
    if (body.model->stiffening) {
      const space::DrawnInward drawn = body.kind->calc_handle_drawn(body, outer->handle);
      const space::Rotation& R_HB = body.model->stiffening->R_HB;
      slide.shift -= axis.dot(R_HB * drawn.place);
      slide.rate -= axis.dot(R_HB * drawn.rate);
    }
    outer = body.model;
  }
  return slide;
}

PartList parts_of_slide(std::size_t j, const SubsystemData<Space>& data) {
  PartList list{data.parts.bodies[j].coordinates};
  for (int k = data.bodies[j].model->parent; k >= 0;
       k = data.bodies[static_cast<std::size_t>(k)].model->parent)
    if (data.bodies[static_cast<std::size_t>(k)].model->stiffening)
      list.push_back(data.parts.bodies[static_cast<std::size_t>(k)].coordinates);
  return list;
}

ShiftedJoint::ShiftedJoint(const BodyData<Space>& body, const space::SlideState& slide) noexcept
    : state(joint_state_of(body)) {
  assert(body.model->joint.slide &&
         body.model->joint.slide->coordinate < body.model->joint.joint.coordinates);
  const space::TreeJoint& joint = body.model->joint;
  std::copy_n(state.q, joint.joint.coordinates, q.begin());
  std::copy_n(state.v, joint.joint.coordinates, v.begin());
  q[static_cast<std::size_t>(joint.slide->coordinate)] += slide.shift;
  v[static_cast<std::size_t>(joint.slide->coordinate)] += slide.rate;
  state.q = q.data();
  state.v = v.data();
}

void calc_terms(const System<Space>& system, const Subsystem<Space>& subsystem, double t,
                const space::ImplicitShares& shares, int j, SubsystemData<Space>& data) noexcept {
  assert(j >= 0 && std::cmp_less(j, data.bodies.size()));
  assert(data.bodies.size() == subsystem.bodies.size());
  const auto index = static_cast<std::size_t>(j);
  BodyData<Space>& body = data.bodies[index];
  const space::Twist& twist = data.twists[index];
  body.kind->calc_terms(system, t, shares, index, data);
  if (body.model->stiffening && has_working_field(system, data))
    body.terms.load_power += calc_tension_power(body.terms.tension, angular(data.hub->twist),
                                                calc_working_field(system, t, data));
  add_joint_forces(t, shares, body);
  add_efforts(shares, body);
  const bool rises = system.gravity_ramp > 0.0;  // gravity
  space::Rotation R_HB;
  if (rises || is_resolved(body)) R_HB = calc_rotation_to_hub(subsystem, data, j);
  body.kind->add_applied(t, R_HB, index, data);
  if (!rises) return;
  const space::Position gravity = data.hub->R.inverse() * space::Position(system.gravity_at(t));
  const bool falls = system.hub.support == HubSupport::free;
  add_gravity_power(gravity, falls ? space::Position(space::Position::Zero()) : gravity, R_HB,
                    *data.hub, twist, body);
}

PartList parts_of_terms(const System<Space>& system, std::size_t i, std::size_t j,
                        bool has_implicit, const StepData<Space>& table) {
  const SubsystemData<Space>& data = table.subsystems[i];
  const BodyData<Space>& body = data.bodies[j];
  const SubsystemParts& parts = data.parts;
  const BodyParts& own = parts.bodies[j];
  const std::vector<BodyLoad<Space>>& loads = body.model->loads;
  const bool has_tension = static_cast<bool>(body.model->stiffening);
  const bool rises = system.gravity_ramp > 0.0;  // gravity
  PartList list = loads_on(i, j, table);
  graph::add_to(list, own.coordinates, parts.twists, graph::maybe(own.carried));
  if (has_implicit) {
    list.push_back(own.history);  // q_elastic and v_elastic
    if (body.model->joint.joint.coordinates > 0 || own.tension.index >= 0)
      list.push_back(own.accelerations);
  }
  if (body.model->joint.slide || (has_tension && body.forces.carried))
    list.push_back(parts.applied_forces);
  if (has_tension && data.flight_acceleration) list.push_back(table.parts.flight_acceleration);
  if (rises || (has_tension && body.forces.applied) || is_any_in(spatial::LoadFrame::hub, loads) ||
      is_any_in(spatial::LoadFrame::inertial, loads))
    list.push_back(parts.rotations);
  // The tension may stand on either side of the equations.
  if (rises || has_tension || is_any_in(spatial::LoadFrame::inertial, loads))
    list.push_back(parts.hub_state);
  return list;
}

}  // namespace spoke
