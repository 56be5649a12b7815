// Evaluates the drive, and what it imposes on the hub.

#include "engine/kernels/hub_motion.h"

namespace spoke {

Twist calc_prescribed_acceleration(const System& system, double t, const Rotation& R,
                                   double alpha) {
  Twist given = Twist::Zero();
  if (is_prescribed(system.hub, 0)) given.head<kPosition>() = -(R.inverse() * system.gravity_at(t));
  if (is_prescribed(system.hub, kRotation)) given[kRotation] = alpha;
  return given;
}

void impose_hub_motion(const System& system, double t, CoordinateBlock& hub) noexcept {
  for (int c = 0; c < kPosition; ++c)
    if (is_prescribed(system.hub, c)) hub.q[c] = hub.v[c] = hub.a[c] = 0.0;
  if (!is_prescribed(system.hub, kRotation)) return;
  const DriveMotion motion = calc_motion(system.hub.drive, t);
  hub.q[kRotation] = motion.angle;
  hub.v[kRotation] = motion.speed;
  hub.a[kRotation] = motion.acceleration;
}

PrescribedHub calc_prescribed_motion(const System& system, double t) noexcept {
  const DriveMotion motion = calc_motion(system.hub.drive, t);
  const Rotation R = Rotation::from_angle(motion.angle);
  return {{Position::Zero(), R, Twist(0.0, 0.0, motion.speed)},
          calc_prescribed_acceleration(system, t, R, motion.acceleration)};
}

Twist calc_root_acceleration(const Subsystem& subsystem, const HubState& hub,
                             const Twist& hub_acceleration, const Rotation& R_HB) {
  // T Y'' + [-w0^2 p; 0] with T = [I, B p; 0, 1]: the acceleration of the bracket, hub frame.
  const double w = hub.twist[kRotation];
  const Position& p = subsystem.root.p;
  Twist bracket = hub_acceleration;
  bracket.head<kPosition>() += hub_acceleration[kRotation] * quarter_turn(p) - w * w * p;
  return R_HB.inverse() * bracket;
}

Twist calc_inertial_acceleration(const System& system, double t, const HubState& hub,
                                 const HubSolution& solution) {
  Twist inertial = hub.R * solution.acceleration;
  inertial.head<kPosition>() += system.gravity_at(t);
  for (int c = 0; c < kPosition; ++c)
    if (is_prescribed(system.hub, c)) inertial[c] = 0.0;
  return inertial;
}

bool is_prescribed(const Hub& hub) {
  for (int c = 0; c < kTwist; ++c)
    if (!is_prescribed(hub, c)) return false;
  return true;
}

}  // namespace spoke
