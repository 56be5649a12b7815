// Evaluates position, velocity and acceleration of a marker in space.

#include "engine/bodies/kernels/marker_motion.h"

#include <cassert>
#include <span>
#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/table/body_kind.h"

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

/// Returns the pose of body j's frame in the inertial frame.
space::Pose calc_pose(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data, int j) {
  const space::Pose hub{data.hub->p, data.hub->R};
  return after(hub, calc_pose_in_hub(subsystem, data, j));
}

/// Returns the motion of a marker on a body at `pose`, whose section moves against it by `section`.
MarkerMotion calc_motion_on(const space::Pose& pose, const SubsystemData<Space>& data,
                            const PlacedMarker<Space>& marker, const space::HandleMotion& section) {
  const space::Twist velocity =
      section.carry(data.twists[static_cast<std::size_t>(marker.body)]) + section.twist();
  MarkerMotion motion;
  motion.position = pose.p + pose.R * section.s;
  motion.rotation = (pose.R * section.turn.R * marker.section.axes).axes;
  motion.velocity = pose.R * space::Position(linear(velocity));
  motion.angular_velocity = pose.R * space::Angular(angular(velocity));
  return motion;
}

/// Returns by what the marker's own body draws it inward, in the hub frame.
space::DrawnInward calc_drawn_on(const SubsystemData<Space>& data,
                                 const PlacedMarker<Space>& marker) {
  const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(marker.body)];
  if (!body.model->stiffening) return {};
  const space::DrawnInward drawn = body.kind->calc_section_drawn(body, marker.section);
  const space::Rotation& R_HB = body.model->stiffening->R_HB;
  return {R_HB * drawn.place, R_HB * drawn.rate};
}

/// Returns by what the bodies inboard of one draw it inward, in the hub frame.
space::DrawnInward calc_drawn_inboard(const SubsystemData<Space>& data, int outer) {
  space::DrawnInward sum;
  Eigen::Matrix3d pass = Eigen::Matrix3d::Identity();
  const TreeBody<Space>* model = data.bodies[static_cast<std::size_t>(outer)].model;
  while (model->parent >= 0) {
    if (const auto& slide = model->joint.slide)  // it does not follow those inboard along it
      pass -= (pass * slide->axis) * slide->axis.transpose();
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(model->parent)];
    if (body.model->stiffening) {
      const space::DrawnInward drawn = body.kind->calc_handle_drawn(body, model->handle);
      sum.place += pass * (body.model->stiffening->R_HB * drawn.place);
      sum.rate += pass * (body.model->stiffening->R_HB * drawn.rate);
    }
    model = body.model;
  }
  return sum;
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
  const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(marker.body)];
  return calc_motion_on(calc_pose(subsystem, data, marker.body), data, marker,
                        motion_at(body, marker.section));
}

MarkerMotion calc_load_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                              const PlacedMarker<Space>& marker) noexcept {
  MarkerMotion motion;
  space::HandleMotion section;
  calc_load_motions(subsystem, data, {&marker, 1}, {&motion, 1}, {&section, 1});
  return motion;
}

void calc_load_motions(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                       std::span<const PlacedMarker<Space>> markers,
                       std::span<MarkerMotion> motions,
                       std::span<space::HandleMotion> sections) noexcept {
  assert(motions.size() == markers.size() && sections.size() == markers.size());
  space::Pose pose;
  space::DrawnInward inboard;
  for (std::size_t k = 0; k < markers.size(); ++k) {
    const PlacedMarker<Space>& marker = markers[k];
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(marker.body)];
    if (k == 0 || marker.body != markers[k - 1].body) {
      pose = calc_pose(subsystem, data, marker.body);
      inboard = calc_drawn_inboard(data, marker.body);
    }
    sections[k] = motion_at(body, marker.section);
    motions[k] = calc_motion_on(pose, data, marker, sections[k]);
    if (!body.model->stiffening && inboard.place.isZero(0.0) && inboard.rate.isZero(0.0)) continue;
    space::DrawnInward drawn = calc_drawn_on(data, marker);
    drawn.place += inboard.place;
    drawn.rate += inboard.rate;
    const HubState<Space>& hub = *data.hub;
    motions[k].position += hub.R * drawn.place;
    motions[k].velocity +=
        hub.R * space::Position(drawn.rate + cross(angular(hub.twist), drawn.place));
  }
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
      body.kind->calc_section_acceleration(body, marker.section, motion, body.X, w, body.a_found);
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
    sum -= R * (j == marker.body ? body.kind->calc_shown_drawn(body, marker.section)
                                 : body.kind->calc_shown_drawn(body, of_child));
  }
  return sum;
}

}  // namespace spoke
