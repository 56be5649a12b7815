#include "engine/hub.h"

#include <Eigen/LU>

namespace spoke {

Twist calc_prescribed_acceleration(const System& system, const Rotation& R, double alpha) {
  Twist given = Twist::Zero();
  if (is_prescribed(system.hub, 0)) given.head<kPosition>() = -(R.inverse() * system.gravity);
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
          calc_prescribed_acceleration(system, R, motion.acceleration)};
}

Twist calc_reaction(const SubsystemData& subsystem) noexcept {
  const EffectiveInertia& effective = subsystem.effective;
  const Twist& a = *subsystem.hub_acceleration;
  Twist reaction = effective.mass * a - effective.force;
  reaction[kRotation] -= effective.centrifugal_inertia * a[kRotation] +
                         2.0 * subsystem.hub->twist[kRotation] * effective.centrifugal_rate;
  return reaction;
}

bool is_prescribed(const Hub& hub) {
  for (int c = 0; c < kTwist; ++c)
    if (!is_prescribed(hub, c)) return false;
  return true;
}

HubEquation sum_hub_equation(const System& system, const StepData& data) noexcept {
  const Hub& hub = system.hub;
  HubEquation sum;
  sum.mass = Twist(hub.mass, hub.mass, hub.inertia).asDiagonal();
  sum.force = Twist::Zero();
  sum.force[kRotation] = calc_torque(hub.drive, data.clocks[0].control.time);
  for (const SubsystemData& subsystem : data.subsystems) {
    const EffectiveInertia& effective = subsystem.effective;
    sum.mass += effective.mass;
    sum.force += effective.force;
    sum.mass(kRotation, kRotation) -= effective.centrifugal_inertia;
    sum.force[kRotation] += 2.0 * data.hub.twist[kRotation] * effective.centrifugal_rate;
  }
  return sum;
}

void solve_hub(const System& system, StepData& data) noexcept {
  const HubEquation equation = sum_hub_equation(system, data);
  const Twist given =
      calc_prescribed_acceleration(system, data.hub.R, data.hub_coordinates.a[kRotation]);
  TwistMatrix matrix = equation.mass;
  Twist right = equation.force;
  int prescribed = 0;
  for (int c = 0; c < kTwist; ++c) {
    if (!is_prescribed(system.hub, c)) continue;
    matrix.row(c) = Twist::Unit(c);
    right[c] = given[c];
    ++prescribed;
  }
  HubSolution& solution = data.hub_solution;
  solution.acceleration = right;
  if (prescribed < kTwist) solution.acceleration = matrix.partialPivLu().solve(right);
  solution.reaction = equation.mass * solution.acceleration - equation.force;
  for (int c = 0; c < kTwist; ++c)
    if (!is_prescribed(system.hub, c)) solution.reaction[c] = 0.0;
  solution.applied_torque = calc_torque(system.hub.drive, data.clocks[0].control.time);
}

Twist calc_root_acceleration(const Subsystem& subsystem, const HubState& hub,
                             const Twist& hub_acceleration, const Rotation& R_HB) {
  // [I, B p; 0, 1] Y'' - w0^2 p: the acceleration of the bracket, hub frame.
  const double w = hub.twist[kRotation];
  const Position& p = subsystem.root.p;
  Twist bracket = hub_acceleration;
  bracket.head<kPosition>() += hub_acceleration[kRotation] * quarter_turn(p) - w * w * p;
  return R_HB.inverse() * bracket;
}

Twist calc_inertial_acceleration(const System& system, const HubState& hub,
                                 const HubSolution& solution) {
  Twist inertial = hub.R * solution.acceleration;
  inertial.head<kPosition>() += system.gravity;
  for (int c = 0; c < kPosition; ++c)
    if (is_prescribed(system.hub, c)) inertial[c] = 0.0;
  return inertial;
}

}  // namespace spoke
