// Evaluates the drive, and the motion that it imposes on the hub.

#include "engine/bodies/kernels/hub_motion.h"

#include <cassert>

#include "models/space/mount.h"
#include "models/space/rotation_vector.h"

namespace spoke {

namespace {

// Accelerations that a moving mount adds to the hub. The mount of the plane stands still.

void carry(const System<Plane>&, double, const HubState<Plane>&, Twist&) {}
/// Adds the mount's share to the acceleration of the hub, in H: that of the axle, its linear a and
/// R_HA alpha + (R_HA w) x (0, 0, s), with the rotation R_HA from the axle's frame and the hub's
/// speed s about the axle.
void carry(const System<Space>& system, double t, const HubState<Space>& hub,
           space::Twist& acceleration) {
  if (!system.hub.mount) return;
  const space::AxleMotion axle = calc_axle_motion(system.hub, t);
  const space::Rotation back = hub.R.inverse();
  const space::Rotation turn = back * axle.R;
  const space::Angular w = turn * axle.w;
  const space::Angular spin(0.0, 0.0, hub.twist[Space::kAxial] - w.z());
  linear(acceleration) += back * axle.a;
  angular(acceleration) += turn * axle.alpha + cross(w, spin);
}

void impose_mount(const System<Plane>&, double, CoordinateBlock&) {}
void impose_mount(const System<Space>& system, double t, CoordinateBlock& hub) {
  if (!system.hub.mount) return;
  const space::AxleMotion axle = calc_axle_motion(system.hub, t);
  const double angle = hub.q[Space::kAxial];
  const space::Rotation back = space::exponential(space::Angular(0.0, 0.0, -angle));
  const space::Angular w = back * axle.w;
  const space::Angular spin(0.0, 0.0, hub.v[Space::kAxial]);
  const space::Angular alpha = back * axle.alpha + cross(w, spin);
  for (int c = 0; c < space::kPosition; ++c) {
    hub.q[c] = axle.p[c];
    hub.v[c] = axle.v[c];
    hub.a[c] = axle.a[c];
  }
  for (int c = 0; c + 1 < space::kAngular; ++c) {
    hub.v[space::kRotation + c] = w[c];
    hub.a[space::kRotation + c] = alpha[c];
  }
}

HubState<Plane> calc_prescribed_state(const System<Plane>& system, double,
                                      const DriveMotion& motion) {
  return {Position::Zero(), rotation_of(system.hub, motion.angle),
          Twist::Unit(Plane::kAxial) * motion.speed};
}
HubState<Space> calc_prescribed_state(const System<Space>& system, double t,
                                      const DriveMotion& motion) {
  space::Twist twist = space::Twist::Unit(Space::kAxial) * motion.speed;
  if (!system.hub.mount)
    return {space::Position::Zero(), rotation_of(system.hub, motion.angle), twist};
  const space::AxleMotion axle = calc_axle_motion(system.hub, t);
  const space::Rotation turn = space::exponential(space::Angular(0.0, 0.0, motion.angle));
  const space::Rotation R = axle.R * turn;
  linear(twist) = R.inverse() * axle.v;
  angular(twist) += turn.inverse() * axle.w;
  return {axle.p, R, twist};
}

}  // namespace

double calc_carried_spin_up(const System<Space>& system, double t) noexcept {
  return system.hub.mount ? calc_axle_motion(system.hub, t).alpha.z() : 0.0;
}

space::Twist calc_recorded_twist(const SystemRecord<Space>& record) noexcept {
  space::Twist twist = record.velocity;
  linear(twist) = record.hub_rotation.inverse() * space::Position(linear(record.velocity));
  twist[Space::kAxial] += record.hub_rotation.mount_spin;
  return twist;
}

void place_axle(const System<Space>& system, double t, space::HubAttitude& attitude) noexcept {
  if (!system.hub.mount) return;
  const space::AxleMotion axle = calc_axle_motion(system.hub, t);
  attitude.reference = make_quaternion(axle.R);
  attitude.mount_spin = axle.w.z();
}

template <class World>
TwistOf<World> calc_prescribed_acceleration(const System<World>& system, double t,
                                            const HubState<World>& hub, double alpha) {
  TwistOf<World> given = TwistOf<World>::Zero();
  if (is_prescribed(system.hub, 0))
    linear(given) = -(hub.R.inverse() * PositionOf<World>(system.gravity_at(t)));
  if (is_prescribed(system.hub, World::kAxial)) given[World::kAxial] = alpha;
  carry(system, t, hub, given);
  return given;
}

template <class World>
void impose_hub_motion(const System<World>& system, double t, CoordinateBlock& hub) noexcept {
  assert(hub.size == World::kTwist);
  for (int c = 0; c < World::kTwist; ++c)
    if (c != World::kAxial && is_prescribed(system.hub, c)) hub.q[c] = hub.v[c] = hub.a[c] = 0.0;
  if (is_prescribed(system.hub, World::kAxial)) {
    const DriveMotion motion = calc_motion(system.hub.drive, t);
    hub.q[World::kAxial] = motion.angle;
    hub.v[World::kAxial] = motion.speed;
    hub.a[World::kAxial] = motion.acceleration;
  }
  impose_mount(system, t, hub);
}

template <class World>
PrescribedHub<World> calc_prescribed_motion(const System<World>& system, double t) noexcept {
  const DriveMotion motion = calc_motion(system.hub.drive, t);
  const HubState<World> state = calc_prescribed_state(system, t, motion);
  return {state, calc_prescribed_acceleration(system, t, state, motion.acceleration)};
}

template <class World>
TwistOf<World> calc_inertial_acceleration(const System<World>& system, double t,
                                          const HubState<World>& hub,
                                          const HubSolution<World>& solution) {
  TwistOf<World> inertial = solution.acceleration;
  linear(inertial) = hub.R * PositionOf<World>(linear(solution.acceleration));
  linear(inertial) += system.gravity_at(t);
  for (int c = 0; c < World::kPosition; ++c)
    if (is_prescribed(system.hub, c)) inertial[c] = 0.0;
  inertial[World::kAxial] -= calc_carried_spin_up(system, t);
  return inertial;
}

template <class World>
bool is_prescribed(const System<World>& system) {
  for (int c = 0; c < World::kTwist; ++c)
    if (!is_prescribed(system.hub, c)) return false;
  return true;
}

template Twist calc_inertial_acceleration(const System<Plane>&, double, const HubState<Plane>&,
                                          const HubSolution<Plane>&);
template Twist calc_prescribed_acceleration(const System<Plane>&, double, const HubState<Plane>&,
                                            double);
template void impose_hub_motion(const System<Plane>&, double, CoordinateBlock&) noexcept;
template PrescribedHub<Plane> calc_prescribed_motion(const System<Plane>&, double) noexcept;
template bool is_prescribed(const System<Plane>&);
template space::Twist calc_inertial_acceleration(const System<Space>&, double,
                                                 const HubState<Space>&, const HubSolution<Space>&);
template space::Twist calc_prescribed_acceleration(const System<Space>&, double,
                                                   const HubState<Space>&, double);
template void impose_hub_motion(const System<Space>&, double, CoordinateBlock&) noexcept;
template PrescribedHub<Space> calc_prescribed_motion(const System<Space>&, double) noexcept;
template bool is_prescribed(const System<Space>&);

}  // namespace spoke
