// Evaluates the drive, and what it imposes on the hub.

#include "engine/kernels/hub_motion.h"

namespace spoke {

template <class World>
TwistOf<World> calc_prescribed_acceleration(const System<World>& system, double t,
                                            const RotationOf<World>& R, double alpha) {
  TwistOf<World> given = TwistOf<World>::Zero();
  if (is_prescribed(system.hub, 0)) linear(given) = -(R.inverse() * system.gravity_at(t));
  if (is_prescribed(system.hub, World::kAxial)) given[World::kAxial] = alpha;
  return given;
}

template <class World>
void impose_hub_motion(const System<World>& system, double t, CoordinateBlock& hub) noexcept {
  for (int c = 0; c < World::kTwist; ++c)
    if (c != World::kAxial && is_prescribed(system.hub, c)) hub.q[c] = hub.v[c] = hub.a[c] = 0.0;
  if (!is_prescribed(system.hub, World::kAxial)) return;
  const DriveMotion motion = calc_motion(system.hub.drive, t);
  hub.q[World::kAxial] = motion.angle;
  hub.v[World::kAxial] = motion.speed;
  hub.a[World::kAxial] = motion.acceleration;
}

template <class World>
PrescribedHub<World> calc_prescribed_motion(const System<World>& system, double t) noexcept {
  const DriveMotion motion = calc_motion(system.hub.drive, t);
  const auto R = RotationOf<World>::about_axis(motion.angle);
  return {{PositionOf<World>::Zero(), R, TwistOf<World>::Unit(World::kAxial) * motion.speed},
          calc_prescribed_acceleration(system, t, R, motion.acceleration)};
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
template Twist calc_prescribed_acceleration(const System<Plane>&, double, const Rotation&, double);
template void impose_hub_motion(const System<Plane>&, double, CoordinateBlock&) noexcept;
template PrescribedHub<Plane> calc_prescribed_motion(const System<Plane>&, double) noexcept;
template bool is_prescribed(const System<Plane>&);

}  // namespace spoke
