// Calculates rotations, poses and velocities along a chain, from the root to the tip.

#include "engine/bodies/kernels/kinematics.h"

#include <cassert>
#include <utility>

#include "engine/bodies/kernels/plane/handle_motion.h"

namespace spoke {
namespace {

/// Returns this part of the bodies up to the last that moves what the kinematics find.
PartList chain_parts(const SubsystemData<Plane>& data, graph::PartId BodyParts::*part) {
  PartList list = data.parts.all(part);
  if (!turns_inboard(*data.bodies.back().model->body)) list.pop_back();
  return list;
}

}  // namespace

template <class World>
void calc_rotations(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept {
  assert(data.bodies.size() == subsystem.bodies.size() && data.joints.size() == data.bodies.size());
  // The bracket is the parent's outboard section; its rotation is in the parent's frame.
  RotationOf<World> bracket = subsystem.root.R;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<World>& member = data.bodies[j];
    data.joints[j].R = bracket * calc_inboard_rotation(member).inverse();
    if (j + 1 < data.bodies.size()) bracket = calc_outboard_rotation(member);
  }
}

PartList parts_of_rotations(const SubsystemData<Plane>& data) {
  return chain_parts(data, &BodyParts::coordinates);
}

template <class World>
void calc_poses(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                ArenaVector<PoseOf<World>>& poses) noexcept {
  assert(data.bodies.size() == subsystem.bodies.size() && poses.size() == data.bodies.size());
  PoseOf<World> parent;  // in the hub frame
  // The parent carries the body at the bracket, in the parent's frame.
  PositionOf<World> bracket = subsystem.root.p;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    poses[j].p = parent.p + parent.R * bracket;
    poses[j].R = parent.R * data.joints[j].R;
    parent = poses[j];
    bracket = calc_outboard_position(data.bodies[j]);
  }
}

template <class World>
RotationOf<World> calc_rotation_to_hub(const SubsystemData<World>& data, int body) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.joints.size()));
  RotationOf<World> R = data.joints[0].R;
  for (int j = 1; j <= body; ++j) R = R * data.joints[static_cast<std::size_t>(j)].R;
  return R;
}

template <class World>
void calc_velocities(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept {
  assert(data.bodies.size() == subsystem.bodies.size() && data.twists.size() == data.bodies.size());
  // Twist of the bracket that carries the body, resolved in the parent's frame.
  TwistOf<World> bracket = data.hub->twist;
  linear(bracket) += cross(angular(data.hub->twist), subsystem.root.p);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData<World>& member = data.bodies[j];
    TwistOf<World> twist = data.joints[j].R.inverse() * bracket;
    if (turns_inboard(*member.model->body)) angular(twist) -= calc_inboard_rate(member);
    data.twists[j] = twist;
    if (j + 1 == data.bodies.size()) break;
    bracket = carry(twist, calc_outboard_position(member), calc_outboard_velocity(member),
                    calc_outboard_rate(member));
  }
}

void set_angular_accelerations(const System<Plane>&, std::size_t i,
                               StepData<Plane>& data) noexcept {
  assert(i < data.subsystems.size());
  SubsystemData<Plane>& subsystem = data.subsystems[i];
  double alpha = data.is_coupled ? data.hub_coordinates.a[kRotation]
                                 : subsystem.prescribed.acceleration[kRotation];
  for (BodyData<Plane>& body : subsystem.bodies) {
    alpha -= body.coordinates.a[body.inboard_at[kRotation]];
    body.alpha = alpha;
    alpha += body.coordinates.a[body.outboard_at[kRotation]];
  }
}

PartList parts_of_angular_accelerations(std::size_t i, const StepData<Plane>& data) {
  const SubsystemData<Plane>& subsystem = data.subsystems[i];
  if (!needs_angular_accelerations(subsystem)) return {};
  PartList list = chain_parts(subsystem, &BodyParts::accelerations);
  if (data.is_coupled) list.push_back(data.parts.hub_coordinates);
  return list;
}

HubState<Plane> calc_hub_state(const StepData<Plane>& data) {
  const CoordinateBlock& hub = data.hub_coordinates;
  HubState<Plane> state;
  state.p = {hub.q[0], hub.q[1]};
  state.R = plane::Rotation::from_angle(hub.q[kRotation]);
  const Twist inertial(hub.v[0], hub.v[1], hub.v[2]);
  state.twist = state.R.inverse() * inertial;
  return state;
}

template void calc_rotations(const Subsystem<Plane>&, SubsystemData<Plane>&) noexcept;
template void calc_poses(const Subsystem<Plane>&, const SubsystemData<Plane>&,
                         ArenaVector<plane::Pose>&) noexcept;
template plane::Rotation calc_rotation_to_hub(const SubsystemData<Plane>&, int) noexcept;
template void calc_velocities(const Subsystem<Plane>&, SubsystemData<Plane>&) noexcept;

}  // namespace spoke
