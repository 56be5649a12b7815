// Handles of planar bodies as the loops see them, and the accelerations of frames.

#include <cassert>
#include <utility>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/kernels/plane/section_balance.h"

namespace spoke {
namespace {

space::Rotation lift_to_space(const plane::Rotation& R) {
  space::Rotation rotation;
  rotation.axes.topLeftCorner<2, 2>() << R.cosine, -R.sine, R.sine, R.cosine;
  return rotation;
}
space::Twist lift_to_space(const Twist& twist) {
  return space::make_twist(space::Position(twist[0], twist[1], 0.0),
                           space::Angular(0.0, 0.0, twist[2]));
}

/// Returns the accelerations of the coordinates of a handle.
Twist deform(const BodyData<Plane>& body, const std::array<int, kTwist>& at) {
  const double* a = body.coordinates.a;
  return {a[at[0]], a[at[1]], a[at[kRotation]]};
}

/// Returns the acceleration of the outboard handle of a body whose frame moves by X.
Twist calc_outboard_acceleration(const BodyData<Plane>& body, const Twist& twist, const Twist& X) {
  const double w = twist[kRotation];
  const Position s = plane::calc_outboard_position(body);
  const Position carried = Position(X.head<kPosition>()) + X[kRotation] * quarter_turn(s) -
                           w * w * s + 2.0 * w * quarter_turn(plane::calc_outboard_velocity(body));
  return Twist(carried.x(), carried.y(), X[kRotation]) + deform(body, body.outboard_at);
}

}  // namespace

LoopHandle calc_loop_handle(const SubsystemData<Plane>& data, int body,
                            [[maybe_unused]] int handle) noexcept {
  assert(handle == 1 && body >= 0 && std::cmp_less(body, data.loops.poses.size()));
  const BodyData<Plane>& own = data.bodies[body];
  const plane::Pose& pose = data.loops.poses[body];
  const Position s = plane::calc_outboard_position(own);
  const Position p = pose.p + pose.R * s;
  const Twist twist = pose.R * carry(data.twists[body], s, plane::calc_outboard_velocity(own),
                                     plane::calc_outboard_rate(own));
  return {space::Position(p.x(), p.y(), 0.0),
          lift_to_space(pose.R * plane::calc_outboard_rotation(own)), lift_to_space(twist)};
}

Twist turn_to_body(const SubsystemData<Plane>& data, int body,
                   const space::Twist& wrench) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.loops.poses.size()));
  return data.loops.poses[body].R.inverse() * Twist(wrench[0], wrench[1], wrench[5]);
}

Twist calc_loop_hub_acceleration(const System<Plane>& system, std::size_t i, double t,
                                 const StepData<Plane>& data) noexcept {
  return plane::calc_hub_acceleration(system, i, data, t);
}

void calc_loop_accelerations(const Subsystem<Plane>& subsystem, const Twist& hub,
                             SubsystemData<Plane>& data) noexcept {
  assert(data.loops.accelerations.size() == data.bodies.size());
  Twist bracket = hub;
  linear(bracket) += cross(angular(hub), subsystem.root.p) +
                     centripetal(angular(data.hub->twist), subsystem.root.p);
  for (int j = 0; j <= data.loops.last_body; ++j) {
    Twist X = data.joints[j].R.inverse() * bracket;
    // The frame turns against a chord frame's inboard section.
    X[kRotation] -= data.bodies[j].coordinates.a[data.bodies[j].inboard_at[kRotation]];
    data.loops.accelerations[j] = X;
    bracket = calc_outboard_acceleration(data.bodies[j], data.twists[j], X);
  }
}

Twist calc_loop_acceleration(const SubsystemData<Plane>& data, int body,
                             [[maybe_unused]] int handle) noexcept {
  assert(handle == 1 && body >= 0 && std::cmp_less(body, data.loops.accelerations.size()));
  return calc_outboard_acceleration(data.bodies[body], data.twists[body],
                                    data.loops.accelerations[body]);
}

}  // namespace spoke
