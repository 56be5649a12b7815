// Evaluates position, velocity and acceleration of a marker in space.

#include "engine/kernels/marker_motion.h"

#include <cassert>
#include <utility>

#include "engine/kernels/kinematics.h"
#include "engine/space/body_energies.h"
#include "engine/space/solid_table_terms.h"
#include "engine/space/table_terms.h"

namespace spoke {
namespace {

/// Returns the pose B in A after the pose C in B.
space::Pose after(const space::Pose& outer, const space::Pose& inner) {
  return {outer.p + outer.R * inner.p, outer.R * inner.R};
}

/// Returns the pose of body j's frame in its parent's.
space::Pose calc_pose_in_parent(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                                std::size_t j) {
  const TreeBody<Space>& body = subsystem.bodies[j];
  const space::JointMotion& joint = data.joints[j];
  space::Position place = joint.p;
  if (body.parent >= 0)
    place =
        data.bodies[static_cast<std::size_t>(body.parent)].work.handles[body.handle].s + joint.p;
  if (body.body->moves_inboard()) place -= joint.R * data.bodies[j].work.handles[0].s;
  return {place, joint.R};
}

space::Position place_in_hub(const space::Pose& X_HB, const space::HandleMotion& motion) {
  return X_HB.p + X_HB.R * motion.s;
}

}  // namespace

space::Pose calc_pose_in_hub(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                             int body) noexcept {
  assert(body >= 0 && std::cmp_less(body, subsystem.bodies.size()));
  space::Pose pose;
  for (int j = body; j >= 0; j = subsystem.bodies[static_cast<std::size_t>(j)].parent)
    pose = after(calc_pose_in_parent(subsystem, data, static_cast<std::size_t>(j)), pose);
  return pose;
}

space::Pose calc_rest_pose(const Subsystem<Space>& subsystem, int body) noexcept {
  assert(body >= 0 && std::cmp_less(body, subsystem.bodies.size()));
  space::Pose pose;
  for (int j = body; j >= 0; j = subsystem.bodies[static_cast<std::size_t>(j)].parent) {
    const TreeBody<Space>& member = subsystem.bodies[static_cast<std::size_t>(j)];
    pose = after(member.joint.joint.offset, pose);
    if (member.parent >= 0)
      pose.p += subsystem.bodies[static_cast<std::size_t>(member.parent)].body->handle_at_rest(
          static_cast<std::size_t>(member.handle));
  }
  return pose;
}

MarkerMotion calc_marker_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                                const PlacedMarker<Space>& marker) noexcept {
  const auto j = static_cast<std::size_t>(marker.body);
  const HubState<Space>& hub = *data.hub;
  const space::Twist& twist = data.twists[j];
  const space::HandleMotion section = motion_at(data.bodies[j], marker.section);
  const space::Pose X_HB = calc_pose_in_hub(subsystem, data, marker.body);
  const space::Rotation R = hub.R * X_HB.R;
  const space::Twist velocity = section.carry(twist) + section.twist();
  MarkerMotion motion;
  motion.position = hub.p + hub.R * place_in_hub(X_HB, section);
  motion.rotation = (R * section.turn.R * marker.section.axes).axes;
  motion.velocity = R * space::Position(linear(velocity));
  motion.angular_velocity = R * space::Angular(angular(velocity));
  return motion;
}

MarkerMotion calc_load_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                              const PlacedMarker<Space>& marker) noexcept {
  MarkerMotion motion = calc_marker_motion(subsystem, data, marker);
  space::Position place = space::Position::Zero(), rate = space::Position::Zero();
  Eigen::Matrix3d pass = Eigen::Matrix3d::Identity();
  int handle = -1;  // handle by which the path leaves a body; -1: the marker is on it
  for (int j = marker.body; j >= 0;) {
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(j)];
    const TreeBody<Space>& model = *body.model;
    if (model.stiffening) {
      const double *q = body.coordinates.q, *v = body.coordinates.v;
      const space::DrawnInward drawn = handle < 0 ? calc_section_drawn(body, marker.section, q, v)
                                                  : calc_handle_drawn(body, handle, q, v);
      place += pass * (model.stiffening->R_HB * drawn.place);
      rate += pass * (model.stiffening->R_HB * drawn.rate);
    }
    if (const auto& slide = model.joint.slide)  // the body does not follow those inboard along it
      pass -= (pass * slide->axis) * slide->axis.transpose();
    handle = model.handle;
    j = model.parent;
  }
  const HubState<Space>& hub = *data.hub;
  motion.position += hub.R * place;
  motion.velocity += hub.R * space::Position(rate + cross(angular(hub.twist), place));
  return motion;
}

space::Twist calc_marker_acceleration(const space::Position& gravity,
                                      const Subsystem<Space>& subsystem,
                                      const SubsystemData<Space>& data,
                                      const PlacedMarker<Space>& marker) noexcept {
  const auto j = static_cast<std::size_t>(marker.body);
  const BodyData<Space>& body = data.bodies[j];
  const space::HandleMotion motion = motion_at(body, marker.section);
  const space::Angular w = angular(data.twists[j]);
  const space::Twist local =
      calc_section_acceleration(body, marker.section, motion, body.X, w, body.a_found);
  space::Twist acceleration =
      data.hub->R * calc_rotation_to_hub(subsystem, data, marker.body) * local;
  linear(acceleration) += gravity;
  return acceleration;
}

space::Position calc_marker_foreshortening(const Subsystem<Space>& subsystem,
                                           const SubsystemData<Space>& data,
                                           const PlacedMarker<Space>& marker) noexcept {
  space::Position sum = space::Position::Zero();
  int handle = 0;
  for (int j = marker.body; j >= 0; j = subsystem.bodies[static_cast<std::size_t>(j)].parent) {
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(j)];
    const int of_child =
        std::exchange(handle, subsystem.bodies[static_cast<std::size_t>(j)].handle);
    if (!body.model->stiffening) continue;
    const space::Rotation R = calc_rotation_to_hub(subsystem, data, j);
    const double *q = body.coordinates.q, *v = body.coordinates.v;
    if (const space::Solid* solid = body.model->body->solid()) {
      const int place = j == marker.body ? marker.section.place_number
                                         : solid->handles[static_cast<std::size_t>(of_child)];
      sum -= R * calc_solid_drawn(body, place, q, v, nullptr).place;
      continue;
    }
    const space::BodyModel model = body_model_of(body);
    const double shortened =
        j == marker.body ? calc_foreshortening(model, marker.section, q, q, q, body.work).length
                         : calc_foreshortening(model, q, body.work);
    sum += R * space::Position(shortened, 0.0, 0.0);
  }
  return sum;
}

}  // namespace spoke
