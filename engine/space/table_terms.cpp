// Hands the table's data to the kernels of spatial bodies and joints.

#include "engine/space/table_terms.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "engine/kernels/kinematics.h"
#include "engine/space/body_terms.h"
#include "engine/space/nodal_body.h"
#include "engine/space/solid_places.h"
#include "engine/space/solid_table_terms.h"
#include "models/space/mount.h"

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

/// Sets the forces of springs, dampers, stops and motors, and adds their power.
void add_joint_forces(double t, const space::ImplicitShares& shares, BodyData<Space>& body) {
  const space::TreeJoint& model = body.model->joint;
  const int n = model.joint.coordinates;
  if (n == 0) return;
  const space::JointState state = joint_state_of(body);
  std::array<double, space::Joint::kMost> motor = calc_motors(model, t);
  if (model.course.drive) motor[0] += calc_torque(*model.course.drive, t, state.v[0]);
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

/// Adds a wrench in B, and its power.
void add_wrench(const space::Section& section, const space::HandleMotion& motion,
                const space::Twist& wrench, const space::Twist& twist, BodyData<Space>& body) {
  if (body.model->body->solid())
    add_place_wrench(*section.place, motion, wrench, body.terms, body.work);
  else if (body.model->body->flexible())
    add_section_wrench(section, motion, wrench, body.terms, body.work);
  else
    body.terms.Q += translate(motion.s, wrench);
  body.terms.load_power += wrench.dot(motion.carry(twist) + motion.twist());
}

/// Adds the forces on the bodies that a body carries to its tension; `turn`: from the hub's frame.
void add_carried_forces(const TreeBody<Space>& model, const SubsystemData<Space>& data,
                        const space::Rotation& turn, space::AppliedTension& tension) {
  const space::FlexibleBody& flexible = *model.body->flexible();
  for (std::size_t h = 1; h <= model.children.size(); ++h)
    tension.add_at_node(
        flexible.handles[h],
        turn * data.applied_forces[static_cast<std::size_t>(model.children[h - 1])]);
}

/// Returns a load of the scenario on a flexible body at time t [s].
space::LoadInstant find_instant(const BodyLoad<Space>& load, double t, const space::Rotation& R_HB,
                                const space::Rotation& R_0) {
  const space::Twist wrench = make_wrench(load.force, load.moment);
  const double size = load.course->value(t);
  if (load.frame == spatial::LoadFrame::section) return {true, size * wrench};
  return {false, size * (resolve_load(load.frame, R_HB, R_0, {}) * wrench)};
}

/// Adds the loads of the scenario.
void add_loads(double t, const space::Rotation& R_HB, const space::Rotation& R_0,
               const space::Twist& twist, space::AppliedTension* tension,
               const space::Rotation& turn, BodyData<Space>& body) {
  const space::FlexibleBody* flexible = body.model->body->flexible();
  for (const auto& [load, sections, places] : body.loads) {
    if (flexible) {
      add_load(*flexible, sections, find_instant(*load, t, R_HB, R_0), body_state_of(body), twist,
               tension, turn, body.terms, body.work);
      continue;
    }
    for (std::size_t k = 0; k < load->points.size(); ++k) {
      const space::Section place = space::make_rigid_section(load->points[k].place);
      add_wrench(place, motion_at(body, place), calc_load_wrench(*load, k, t, R_HB, R_0, {}), twist,
                 body);
    }
  }
}

/// Whether a body's tension depends on what is applied.
bool has_applied_tension(const BodyData<Space>& body) {
  return body.model->stiffening && body.forces;
}
/// Whether what is applied to a body is resolved in other frames than its own.
bool is_resolved(const BodyData<Space>& body) {
  return !body.loads.empty() || (has_applied_tension(body) && !body.applied.empty());
}

/// Adds all that is applied to body `j`: loads of the user's, then those of the scenario; and the
/// tension of these and of the forces beyond the body. R_HB: only if a load is resolved in other
/// frames.
void add_applied(double t, const space::Rotation& R_HB, std::size_t j, SubsystemData<Space>& data) {
  BodyData<Space>& body = data.bodies[j];
  const TreeBody<Space>& model = *body.model;
  if (model.body->solid()) return add_applied_to_solid(t, R_HB, j, data);
  const space::Twist& twist = data.twists[j];
  std::optional<space::AppliedTension> tension;
  space::Rotation to_undeformed;
  if (has_applied_tension(body)) {
    to_undeformed = model.stiffening->R_HB.inverse();
    tension.emplace(body_model_of(body), body_state_of(body), body.work);
    if (body.forces.carried) add_carried_forces(model, data, to_undeformed, *tension);
  }
  const space::Rotation turn = to_undeformed * R_HB;
  for (const auto& [section, wrench, motion] : body.applied) {
    const space::Twist applied = make_wrench(wrench->force, wrench->moment);
    if (motion)
      add_wrench(*section, *motion, applied, twist, body);
    else
      add_wrench(*section, motion_at(body, *section), applied, twist, body);
    if (tension) tension->add_at(*section, turn * wrench->force);
  }
  add_loads(t, R_HB, data.hub->R, twist, tension ? &*tension : nullptr, turn, body);
  if (!tension) return;
  const space::Angular on_hub = model.stiffening->R_HB * tension->add_to(body.terms);
  body.terms.stiffening.moment += on_hub;
  body.terms.load_power += on_hub.dot(space::Angular(angular(data.hub->twist)));
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
  if (body.model->body->rigid()) {
    body.terms.load_power += gravity.dot(space::Position(linear(rigid_mass_of(body) * twist)));
    return;
  }
  const space::BodyTerms& terms = body.terms;
  const space::Position momentum =
      body.model->body->mass() * linear(twist) + cross(angular(twist), terms.S) + terms.S_rate;
  body.terms.load_power +=
      gravity.dot(momentum) + calc_tension_power(terms.tension, angular(hub.twist), tension_H);
}

}  // namespace

void follow_state(const HubState<Space>& hub, BodyData<Space>& body) noexcept {
  if (body.strain)
    follow_strain(*body.model->body->flexible(), body.coordinates.q, body.work, *body.strain);
  if (body.tension)
    follow_speed(*body.model->body->flexible(), *body.model->stiffening, angular(hub.twist),
                 *body.tension);
}

bool has_implicit_tension(const BodyData<Space>& body) noexcept {
  return body.tension && body.tension->is_on();
}

bool depend_on_pose(const BodyData<Space>& body) noexcept {
  const std::vector<BodyLoad<Space>>& loads = body.model->loads;
  return !body.applied.empty() ||
         std::any_of(loads.begin(), loads.end(), [](const BodyLoad<Space>& load) {
           return load.frame == spatial::LoadFrame::body ||
                  load.frame == spatial::LoadFrame::section;
         });
}

space::Position sum_forces(double t, const Subsystem<Space>& subsystem,
                           const SubsystemData<Space>& data, std::size_t j) noexcept {
  assert(j < data.bodies.size());
  space::Position sum = space::Position::Zero();
  const BodyData<Space>& body = data.bodies[j];
  if (!body.forces.applied) return sum;
  space::Rotation R_HB;
  if (depend_on_pose(body)) R_HB = calc_rotation_to_hub(subsystem, data, static_cast<int>(j));
  const space::FlexibleBody* flexible = body.model->body->flexible();
  for (const auto& [load, sections, places] : body.loads) {
    if (flexible) {
      sum += sum_load_forces(*flexible, sections, find_instant(*load, t, R_HB, data.hub->R),
                             body.coordinates.q);
      continue;
    }
    for (std::size_t k = 0; k < load->points.size(); ++k) {
      space::Rotation section;
      if (!places.empty()) section = motion_at(body, places[k]).turn.R;
      sum += linear(calc_load_wrench(*load, k, t, R_HB, data.hub->R, section));
    }
  }
  for (const AppliedWrench<Space>& at : body.applied) sum += at.wrench->force;
  return R_HB * sum;
}

std::array<double, space::Joint::kMost> calc_motors(const space::TreeJoint& joint,
                                                    double t) noexcept {
  assert(joint.course.efforts.size() <= space::Joint::kMost);
  std::array<double, space::Joint::kMost> motor{};
  for (std::size_t c = 0; c < joint.course.efforts.size(); ++c)
    motor[c] = joint.course.efforts[c].value(t);
  return motor;
}

space::DrawnInward calc_handle_drawn(const BodyData<Space>& body, int handle, const double* q,
                                     const double* v) noexcept {
  const auto h = static_cast<std::size_t>(handle);
  if (const space::Solid* solid = body.model->body->solid()) {
    const space::PlaceDrawn drawn = calc_solid_drawn(body, solid->handles[h], q, v, nullptr);
    return {drawn.place, drawn.rate};
  }
  const space::FlexibleBody* flexible = body.model->body->flexible();
  return flexible ? calc_drawn_inward(*flexible, flexible->handles[h], q, v) : space::DrawnInward{};
}

space::DrawnInward calc_section_drawn(const BodyData<Space>& body, const space::Section& section,
                                      const double* q, const double* v) noexcept {
  if (const space::FlexibleBody* flexible = body.model->body->flexible())
    return calc_drawn_inward(*flexible, section, q, v);
  if (!body.model->body->solid()) return {};
  const space::PlaceDrawn drawn = calc_solid_drawn(body, section.place_number, q, v, nullptr);
  return {drawn.place, drawn.rate};
}

space::Twist calc_section_acceleration(const BodyData<Space>& body, const space::Section& section,
                                       const space::HandleMotion& motion, const space::Twist& X,
                                       const space::Angular& w, const double* a) noexcept {
  if (const space::FlexibleBody* flexible = body.model->body->flexible())
    return calc_section_acceleration(*flexible, section, motion, X, w, a);
  space::Twist acceleration = motion.carry(X) + motion.bias(w);
  if (body.model->body->solid()) acceleration += calc_place_deformation(*section.place, motion, a);
  return acceleration;
}

space::SlideState calc_slide_shift(const SubsystemData<Space>& data, std::size_t j) noexcept {
  assert(j < data.bodies.size() && data.bodies[j].model->joint.slide);
  space::SlideState slide;
  const TreeBody<Space>* outer = data.bodies[j].model;
  const space::Position& axis = outer->joint.slide->axis;
  while (outer->parent >= 0) {
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(outer->parent)];
    if (body.model->stiffening) {
      const space::DrawnInward drawn =
          calc_handle_drawn(body, outer->handle, body.coordinates.q, body.coordinates.v);
      const space::Rotation& R_HB = body.model->stiffening->R_HB;
      slide.shift -= axis.dot(R_HB * drawn.place);
      slide.rate -= axis.dot(R_HB * drawn.rate);
    }
    outer = body.model;
  }
  return slide;
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
  if (const space::RigidBody* rigid = body.model->body->rigid()) {
    body.terms = calc_rigid_terms(*rigid, rigid_mass_of(body), twist);
    if (body.carried) body.terms.Q += body.carried->force;
  } else {
    const HubState<Space>& hub = *data.hub;
    const space::BodyMotion motion{angular(twist), angular(hub.twist),
                                   calc_tension_field(system, t, data)};
    if (is_tiled(body))
      body.terms = sum_nodal_terms(solid_model_of(body), motion, body.work);
    else if (body.model->body->solid())
      body.terms = calc_solid_terms(solid_model_of(body), body_state_of(body), motion,
                                    system.damping, body.work);
    else
      body.terms = calc_body_terms(body_model_of(body), body_state_of(body), motion, system.damping,
                                   body.work);
    if (shares.stiffness != 0.0 && has_implicit_tension(body))
      add_implicit_tension(*body.model->body->flexible(), *body.tension, body.coordinates.a,
                           body.alpha, body.work, body.terms);
    if (shares.stiffness != 0.0 && body.strain)
      add_implicit_strain(*body.model->body->flexible(), *body.strain, body.coordinates.a,
                          body.alpha, body.work, body.terms);
    if (body.model->stiffening && has_working_field(system, data))
      body.terms.load_power += calc_tension_power(body.terms.tension, angular(hub.twist),
                                                  calc_working_field(system, t, data));
  }
  add_joint_forces(t, shares, body);
  const bool rises = system.gravity_ramp > 0.0;  // gravity
  space::Rotation R_HB;
  if (rises || is_resolved(body)) R_HB = calc_rotation_to_hub(subsystem, data, j);
  add_applied(t, R_HB, index, data);
  if (!rises) return;
  const space::Position gravity = data.hub->R.inverse() * space::Position(system.gravity_at(t));
  const bool falls = system.hub.support == HubSupport::free;
  add_gravity_power(gravity, falls ? space::Position(space::Position::Zero()) : gravity, R_HB,
                    *data.hub, twist, body);
}

}  // namespace spoke
