#include "engine/kinematics.h"

namespace spoke {
namespace {

double value_at(int index, const double* q, const FlexLayout& layout) {
  return index < 0 ? 0.0 : q[flex_index(index, layout)];
}

/// Rotation of a handle's section relative to the body frame.
Rotation section_rotation(const Handle& handle, const double* q, const FlexLayout& layout) {
  const int index = handle.coordinate[kRotation];
  return index < 0 ? Rotation{} : Rotation::from_angle(q[flex_index(index, layout)]);
}

}  // namespace

Position calc_handle_velocity(const Handle& handle, const double* v, const FlexLayout& layout) {
  return {value_at(handle.coordinate[0], v, layout), value_at(handle.coordinate[1], v, layout)};
}

Position calc_handle_position(const Handle& handle, const double* q, const FlexLayout& layout) {
  return handle.p + calc_handle_velocity(handle, q, layout);
}

double handle_rotation(const Handle& handle, const double* q, const FlexLayout& layout) {
  return value_at(handle.coordinate[kRotation], q, layout);
}

Position calc_node_position(const FlexibleBody& body, int node, const double* q,
                            const FlexLayout& layout) {
  return {body.length * node / body.elements + value_at(body.coordinate(node, 0), q, layout),
          value_at(body.coordinate(node, 1), q, layout)};
}

void calc_positions(const Subsystem& subsystem, SubsystemData& data) noexcept {
  Pose bracket = subsystem.root;    // of the parent's outboard handle, in the hub frame
  Rotation bracket_in_parent = subsystem.root.R;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData& member = data.bodies[j];
    const FlexibleBody& body = *member.model->body;
    const double* q = member.coordinates.q;
    // The inboard handle sits on the bracket; its node stands at the frame's origin.
    const Rotation back = section_rotation(body.inboard, q, member.layout).inverse();
    BodyPose& pose = data.poses[j];
    pose.R_PB = bracket_in_parent * back;
    pose.X_HB.R = bracket.R * back;
    pose.X_HB.p = bracket.p;
    bracket_in_parent = section_rotation(body.outboard, q, member.layout);
    bracket.p += pose.X_HB.R * calc_handle_position(body.outboard, q, member.layout);
    bracket.R = pose.X_HB.R * bracket_in_parent;
  }
}

void calc_velocities(const Subsystem& subsystem, const HubState& hub, SubsystemData& data) noexcept {
  // Twist of the bracket that carries the body, resolved in the parent's frame.
  const double hub_speed = hub.twist[kRotation];
  Twist bracket = hub.twist;
  bracket.head<kPosition>() += hub_speed * quarter_turn(subsystem.root.p);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData& member = data.bodies[j];
    const FlexibleBody& body = *member.model->body;
    const double* q = member.coordinates.q;
    const double* v = member.coordinates.v;
    Twist& twist = data.twists[j];
    twist = data.poses[j].R_PB.inverse() * bracket;
    twist[kRotation] -= handle_rotation(body.inboard, v, member.layout);
    bracket = twist;
    bracket.head<kPosition>() +=
        twist[kRotation] * quarter_turn(calc_handle_position(body.outboard, q, member.layout)) +
        calc_handle_velocity(body.outboard, v, member.layout);
    bracket[kRotation] += handle_rotation(body.outboard, v, member.layout);
  }
}

HubState calc_hub_state(const CoordinateBlock& hub) {
  HubState state;
  state.R = Rotation::from_angle(hub.q[kRotation]);
  const Twist inertial(hub.v[0], hub.v[1], hub.v[2]);
  state.twist = state.R.inverse() * inertial;
  return state;
}

}  // namespace spoke
