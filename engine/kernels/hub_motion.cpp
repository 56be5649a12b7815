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
TwistOf<World> calc_bracket_bias(const Subsystem<World>& subsystem, const HubState<World>& hub) {
  TwistOf<World> bias = TwistOf<World>::Zero();
  linear(bias) = centripetal(angular(hub.twist), subsystem.root.p);
  return bias;
}

template <class World>
TwistOf<World> calc_root_acceleration(const Subsystem<World>& subsystem, const HubState<World>& hub,
                                      const TwistOf<World>& hub_acceleration,
                                      const RotationOf<World>& R_HB) {
  // T Y'' + [w0 x (w0 x p); 0] with T = [I, B p; 0, 1]: the acceleration of the bracket, hub frame.
  const auto& p = subsystem.root.p;
  TwistOf<World> bracket = hub_acceleration;
  linear(bracket) += cross(angular(hub_acceleration), p) + centripetal(angular(hub.twist), p);
  return R_HB.inverse() * bracket;
}

template <class World>
TwistOf<World> calc_inertial_acceleration(const System<World>& system, double t,
                                          const HubState<World>& hub,
                                          const HubSolution<World>& solution) {
  TwistOf<World> inertial = hub.R * solution.acceleration;
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

template Twist calc_bracket_bias(const Subsystem<Plane>&, const HubState<Plane>&);
template Twist calc_root_acceleration(const Subsystem<Plane>&, const HubState<Plane>&, const Twist&,
                                      const Rotation&);
template Twist calc_inertial_acceleration(const System<Plane>&, double, const HubState<Plane>&,
                                          const HubSolution<Plane>&);
template Twist calc_prescribed_acceleration(const System<Plane>&, double, const Rotation&, double);
template void impose_hub_motion(const System<Plane>&, double, CoordinateBlock&) noexcept;
template PrescribedHub<Plane> calc_prescribed_motion(const System<Plane>&, double) noexcept;
template bool is_prescribed(const System<Plane>&);

}  // namespace spoke
