// Rotations, poses and velocities along a chain, from the root to the tip.

#include "engine/kernels/kinematics.h"

#include "engine/kernels/band_products.h"

namespace spoke {
namespace {

/// Rotation of a handle's section relative to the body frame; `at`: places of its coordinates.
Rotation section_rotation(const Handle& handle, const std::array<int, kTwist>& at,
                          const double* q) {
  return handle.coordinate[kRotation] < 0 ? Rotation{} : Rotation::from_angle(q[at[kRotation]]);
}

}  // namespace

void calc_rotations(const Subsystem& subsystem, SubsystemData& data) noexcept {
  Rotation bracket = subsystem.root.R;  // of the parent's outboard section, in the parent's frame
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData& member = data.bodies[j];
    const FlexibleBody& body = *member.model->body;
    const double* q = member.coordinates.q;
    data.rotations[j] = bracket * section_rotation(body.inboard, member.inboard_at, q).inverse();
    if (j + 1 < data.bodies.size())
      bracket = section_rotation(body.outboard, member.outboard_at, q);
  }
}

double calc_foreshortening(const BodyData& body) noexcept {
  const SymmetricBand<3>* slopes = body.model->slope_integral.get();
  if (!slopes) return 0.0;
  const double* v = body.coordinates.q + body.layout.v();
  const double* rows = slopes->pairs();
  double sum = 0.0;
  for (int i = 0; i < slopes->size(); i += 2, rows += 2 * SymmetricBand<3>::kWidth)
    add_in_order(load_aligned(v + i) * band_rows<3>(rows, i, v), sum);
  return 0.5 * sum;
}

void calc_poses(const Subsystem& subsystem, const SubsystemData& data,
                ArenaVector<Pose>& poses) noexcept {
  Pose parent;                          // in the hub frame
  Position bracket = subsystem.root.p;  // where the parent carries the body, in the parent's frame
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    poses[j].p = parent.p + parent.R * bracket;
    poses[j].R = parent.R * data.rotations[j];
    parent = poses[j];
    bracket = calc_outboard_position(data.bodies[j]);
  }
}

Rotation calc_rotation_to_hub(const SubsystemData& data, int body) noexcept {
  Rotation R = data.rotations[0];
  for (int j = 1; j <= body; ++j) R = R * data.rotations[j];
  return R;
}

void calc_velocities(const Subsystem& subsystem, SubsystemData& data) noexcept {
  // Twist of the bracket that carries the body, resolved in the parent's frame.
  const double hub_speed = data.hub->twist[kRotation];
  Twist bracket = data.hub->twist;
  bracket.head<kPosition>() += hub_speed * quarter_turn(subsystem.root.p);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData& member = data.bodies[j];
    const double* v = member.coordinates.v;
    Twist twist = data.rotations[j].inverse() * bracket;
    if (member.model->body->inboard.coordinate[kRotation] >= 0)
      twist[kRotation] -= v[member.inboard_at[kRotation]];
    data.twists[j] = twist;
    if (j + 1 == data.bodies.size()) break;
    const double w = twist[kRotation];
    const Position s = calc_outboard_position(member);
    const Position s_rate = calc_outboard_velocity(member);
    bracket = Twist(twist[0] - w * s.y() + s_rate.x(), twist[1] + w * s.x() + s_rate.y(),
                    w + v[member.outboard_at[kRotation]]);
  }
}

HubState calc_hub_state(const CoordinateBlock& hub) {
  HubState state;
  state.p = {hub.q[0], hub.q[1]};
  state.R = Rotation::from_angle(hub.q[kRotation]);
  const Twist inertial(hub.v[0], hub.v[1], hub.v[2]);
  state.twist = state.R.inverse() * inertial;
  return state;
}

}  // namespace spoke
