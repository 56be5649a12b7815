// Calculates the motion of a tree in space: handles, joints and frames, from the hub to the tips.

#include "engine/bodies/kernels/kinematics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/pitch_control.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/space/hub_motion.h"
#include "engine/bodies/table/body_kind.h"

namespace spoke {
namespace {

using space::Angular;
using space::HandleMotion;
using space::PrescribedMotion;

/// The handle of a tree that carries a body: its section's rotation and its twist (v + w x s + u',
/// w + H th'), both in the frame of the parent.
struct Carrier {
  space::Rotation section;
  space::Twist twist = space::Twist::Zero();
};

Carrier find_carrier(const TreeBody<Space>& body, const SubsystemData<Space>& data) {
  assert(body.parent < 0 || body.handle < data.bodies[body.parent].work.port.handles);
  if (body.parent < 0) return {{}, data.hub->twist};
  const auto p = static_cast<std::size_t>(body.parent);
  const HandleMotion& handle = data.bodies[p].work.handles[body.handle];
  const space::Twist& v = data.twists[p];
  Carrier carrier{handle.turn.R, v + handle.twist()};
  linear(carrier.twist) += cross(angular(v), handle.s);
  return carrier;
}

/// Returns mean + cosine cos(psi) + sine sin(psi) of the azimuth psi, with its derivatives.
PrescribedMotion follow_azimuth(const spatial::AzimuthMotion& motion, double psi,
                                const DriveMotion& hub) {
  const double c = std::cos(psi), s = std::sin(psi);
  const double swing = motion.cosine * c + motion.sine * s;
  const double slope = motion.sine * c - motion.cosine * s;
  return {motion.mean + swing, slope * hub.speed,
          slope * hub.acceleration - swing * hub.speed * hub.speed};
}

/// Follows a curve: its rate is the derivative, its acceleration the derivative of that. The
/// curve's cubic pieces have a linear one.
PrescribedMotion follow(const spatial::MotionTable& motion, double t) {
  return {motion.value.value(t), motion.value.derivative(t), motion.value.second_derivative(t)};
}

PrescribedMotion follow(const space::SaidMotion& said, double t) {
  const double s = t - said.since;
  return {said.value + s * (said.rate + 0.5 * s * said.acceleration),
          said.rate + s * said.acceleration, said.acceleration};
}

PrescribedMotion prescribe(const space::DrivenMotion& motion, double t, double psi,
                           const DriveMotion& hub) {
  if (const auto* table = std::get_if<spatial::MotionTable>(&motion)) return follow(*table, t);
  if (const auto* azimuth = std::get_if<spatial::AzimuthMotion>(&motion))
    return follow_azimuth(*azimuth, psi, hub);
  return follow(std::get<space::SaidMotion>(motion), t);
}

/// Adds the angle of a controller to the motion of a joint that it moves.
void add_control(const DemandedAngle& control, const ControlState& state, double t,
                 PrescribedMotion& motion) {
  const PrescribedMotion pitch = follow(state, t);
  motion.value += control.sign * pitch.value;
  motion.rate += control.sign * pitch.rate;
  motion.acceleration += control.sign * pitch.acceleration;
}

/// Returns the angular acceleration of the hub, in its frame.
Angular calc_hub_angular_acceleration(const System<Space>& system, double t, std::size_t i,
                                      const StepData<Space>& data) {
  if (const int rotor = data.subsystems[i].rotor; rotor >= 0)
    return angular(data.rotors[static_cast<std::size_t>(rotor)].acceleration);
  if (!data.is_coupled) return angular(data.subsystems[i].prescribed.acceleration);
  const CoordinateBlock& hub = data.hub_coordinates;
  space::Twist given = calc_prescribed_acceleration(system, t, data.hub, hub.a[Space::kAxial]);
  for (int c = space::kPosition; c < space::kTwist; ++c)
    if (!is_prescribed(system.hub, c)) given[c] += hub.a[c];
  return angular(given);
}

/// Whether a pass takes tension of any body to its left-hand side. In the first pass of a step the
/// tension is made that of the hub's speed after this.
bool has_tension(const PassControl& control, const SubsystemData<Space>& subsystem) {
  const Angular w = angular(subsystem.hub->twist);
  return std::any_of(
      subsystem.bodies.begin(), subsystem.bodies.end(), [&](const BodyData<Space>& body) {
        if (body.strain) return true;
        if (!body.tension) return false;
        return control.begins_iteration() ? body.tension->counts_at(w) : body.tension->is_on();
      });
}

/// Returns the angular acceleration of the section at a handle besides that of the frame: H th'' +
/// b.
Angular calc_section_acceleration(const BodyData<Space>& body, int handle, const Angular& w) {
  assert(handle >= 0 && handle < body.work.port.handles);
  Angular sum = angular(body.work.handles[handle].bias(w));
  body.kind->add_handle_turning(body, handle, sum);
  return sum;
}

/// Returns the rotation of the hub that carries subsystem `i`, whose angle is the azimuth.
DriveMotion calc_hub_rotation(const System<Space>& system, double t, std::size_t i,
                              const StepData<Space>& data) {
  if (const int rotor = data.subsystems[i].rotor; rotor >= 0)
    return data.rotors[static_cast<std::size_t>(rotor)].turn;
  const CoordinateBlock& hub = data.hub_coordinates;
  if (prescribes_motion(system.hub.drive)) return calc_motion(system.hub.drive, t);
  return {hub.q[Space::kAxial], hub.v[Space::kAxial], hub.a[Space::kAxial]};
}

}  // namespace

bool follows_free_hub(const System<Space>& system, const Subsystem<Space>& subsystem) {
  if (subsystem.rotor >= 0) return false;  // it follows the hub's state
  return !prescribes_motion(system.hub.drive) && follows_azimuth(subsystem);
}

bool follows_azimuth(const Subsystem<Space>& subsystem) {
  for (const TreeBody<Space>& body : subsystem.bodies)
    for (const space::DrivenMotion& motion : body.joint.course.driven)
      if (std::holds_alternative<spatial::AzimuthMotion>(motion)) return true;
  return false;
}

void prescribe_joints(const System<Space>& system, double t, std::size_t i,
                      StepData<Space>& data) noexcept {
  assert(i < system.subsystems.size() && i < data.subsystems.size());
  const DriveMotion hub = calc_hub_rotation(system, t, i, data);
  const Subsystem<Space>& subsystem = system.subsystems[i];
  for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
    const space::JointCourse& course = subsystem.bodies[j].joint.course;
    if (course.drive && !course.driven.empty()) {
      const DriveMotion turn = calc_motion(*course.drive, t);
      const double ratio = course.drive_ratio;
      data.subsystems[i].bodies[j].joint.driven[0] = {ratio * turn.angle, ratio * turn.speed,
                                                      ratio * turn.acceleration};
      continue;
    }
    PrescribedMotion* const driven = data.subsystems[i].bodies[j].joint.driven;
    for (std::size_t c = 0; c < course.driven.size(); ++c)
      driven[c] = prescribe(course.driven[c], t, hub.angle + course.azimuth, hub);
    if (course.control < 0) continue;
    const auto k = static_cast<std::size_t>(course.control);
    add_control(subsystem.controls[k], data.subsystems[i].controls[k], t, driven[0]);
  }
}

PartList parts_of_prescribed_joints(const System<Space>& system, std::size_t i,
                                    const StepData<Space>& data) {
  PartList list = courses_of(i, data);
  const Subsystem<Space>& subsystem = system.subsystems[i];
  if (follows_free_hub(system, subsystem)) list.push_back(data.parts.hub_coordinates);
  if (subsystem.rotor >= 0 && follows_azimuth(subsystem))
    list.push_back(data.subsystems[i].parts.hub_state);
  return list;
}

void calc_rotations([[maybe_unused]] const Subsystem<Space>& subsystem,
                    SubsystemData<Space>& data) noexcept {
  assert(data.bodies.size() == subsystem.bodies.size());
  for (BodyData<Space>& body : data.bodies) body.kind->place_handles(body);
}

PartList parts_of_rotations(const SubsystemData<Space>& data) {
  return data.parts.all(&BodyParts::coordinates);
}

void calc_velocities(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept {
  assert(data.joints.size() == data.bodies.size() && data.twists.size() == data.bodies.size());
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const TreeBody<Space>& model = subsystem.bodies[j];
    const Carrier carrier = find_carrier(model, data);
    calc_joint_motion(model.joint.joint, joint_state_of(data.bodies[j]), carrier.section,
                      carrier.twist, data.joints[j], data.twists[j]);
    data.bodies[j].kind->leave_inboard(data.bodies[j], data.joints[j], data.twists[j]);
  }
}

void set_angular_accelerations(const System<Space>& system, std::size_t i,
                               StepData<Space>& data) noexcept {
  assert(i < data.subsystems.size());
  SubsystemData<Space>& subsystem = data.subsystems[i];
  const PassControl& control = subsystem.progress->control;
  if (!control.is_implicit || !has_tension(control, subsystem)) return;
  const Angular hub = calc_hub_angular_acceleration(system, control.time, i, data);
  for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
    BodyData<Space>& body = subsystem.bodies[j];
    const TreeBody<Space>& model = *body.model;
    const space::JointMotion& joint = subsystem.joints[j];
    Angular sum = hub;
    if (model.parent >= 0) {
      const auto p = static_cast<std::size_t>(model.parent);
      const BodyData<Space>& parent = subsystem.bodies[p];
      sum = parent.alpha +
            calc_section_acceleration(parent, model.handle, angular(subsystem.twists[p]));
    }
    sum += angular(joint.bias);
    for (int c = 0; c < body.joint.coordinates.size; ++c)
      sum += body.joint.coordinates.a[c] * joint.columns.col(c).tail<3>();
    body.alpha = Angular(joint.R.inverse() * space::Position(sum)) -
                 calc_section_acceleration(body, 0, angular(subsystem.twists[j]));
  }
}

PartList parts_of_angular_accelerations(std::size_t i, const StepData<Space>& data) {
  const SubsystemData<Space>& subsystem = data.subsystems[i];
  if (!needs_angular_accelerations(subsystem)) return {};
  PartList list = subsystem.parts.all(&BodyParts::accelerations);
  for (const BodyParts& body : subsystem.parts.bodies)  // whether there is any at this speed
    graph::add_to(list, graph::maybe(body.tension));
  if (data.is_coupled && subsystem.rotor < 0) list.push_back(data.parts.hub_coordinates);
  return list;
}

void calc_poses(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                ArenaVector<space::Pose>& poses) noexcept {
  assert(data.bodies.size() == subsystem.bodies.size() && poses.size() == data.bodies.size());
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const TreeBody<Space>& model = subsystem.bodies[j];
    const space::JointMotion& joint = data.joints[j];
    if (model.parent < 0) {
      poses[j] = {joint.p, joint.R};
    } else {
      const auto p = static_cast<std::size_t>(model.parent);
      const space::Position s = data.bodies[p].work.handles[model.handle].s;
      poses[j] = {poses[p].p + poses[p].R * space::Position(s + joint.p), poses[p].R * joint.R};
    }
    if (model.body->moves_inboard()) poses[j].p -= poses[j].R * data.bodies[j].work.handles[0].s;
  }
}

space::Rotation calc_rotation_to_hub(const Subsystem<Space>& subsystem,
                                     const SubsystemData<Space>& data, int body) noexcept {
  assert(body >= 0 && std::cmp_less(body, subsystem.bodies.size()));
  space::Rotation R = data.joints[static_cast<std::size_t>(body)].R;
  for (int j = subsystem.bodies[static_cast<std::size_t>(body)].parent; j >= 0;
       j = subsystem.bodies[static_cast<std::size_t>(j)].parent)
    R = data.joints[static_cast<std::size_t>(j)].R * R;
  return R;
}

HubState<Space> calc_hub_state(const StepData<Space>& data) {
  const CoordinateBlock& hub = data.hub_coordinates;
  const space::HubState state = space::calc_hub_state(hub.q, hub.v, data.hub_attitude);
  return {state.p, state.R, state.twist};
}

}  // namespace spoke
