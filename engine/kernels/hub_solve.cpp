// Sums the subsystems' effective inertias and solves for the free components and the reactions.

#include "engine/kernels/hub_solve.h"

#include <Eigen/LU>

#include "engine/kernels/hub_motion.h"

namespace spoke {

Twist calc_hub_load(const System& system, double t, const HubState& hub) noexcept {
  Twist sum = Twist::Zero();
  for (const HubLoad& load : system.hub_loads) {
    const double factor = load.factor.value(t) * calc_rise(t, load.ramp);
    const Position force =
        load.frame == LoadFrame::inertial ? Position(hub.R.inverse() * load.force) : load.force;
    sum += factor * translate(load.position, Twist(force.x(), force.y(), load.torque));
  }
  return sum;
}

void set_applied(const System& system, StepData& data) noexcept {
  const double t = data.progress[0].control.time;
  data.hub_solution.applied_torque = calc_torque(system.hub.drive, t, data.hub.twist[kRotation]);
  data.hub_solution.load = calc_hub_load(system, t, data.hub);
}

Twist calc_hub_force(const HubSolution& applied) noexcept {
  Twist force = applied.load;
  force[kRotation] += applied.applied_torque;
  return force;
}

HubEquation sum_hub_equation(const System& system, const StepData& data) noexcept {
  const Hub& hub = system.hub;
  // (1) M_0 + sum M^C - diag(0, 0, sum qf^T KG qf), and Q_0 + sum Q^C + (0, 0, 2 w0 sum qf^T KG
  // qf').
  HubEquation sum;
  sum.mass = Twist(hub.mass, hub.mass, hub.inertia).asDiagonal();
  sum.force = calc_hub_force(data.hub_solution);
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
  set_applied(system, data);
  const HubEquation equation = sum_hub_equation(system, data);
  const Twist given = calc_prescribed_acceleration(system, data.progress[0].control.time,
                                                   data.hub.R, data.hub_coordinates.a[kRotation]);
  // (2) A prescribed component is given: its row becomes that of the identity.
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
  // (3) The reaction is what is left of the equation; of free components there is none.
  solution.reaction = equation.mass * solution.acceleration - equation.force;
  for (int c = 0; c < kTwist; ++c)
    if (!is_prescribed(system.hub, c)) solution.reaction[c] = 0.0;
}

Twist calc_reaction(const SubsystemData& subsystem) noexcept {
  const EffectiveInertia& effective = subsystem.effective;
  const Twist& a = *subsystem.hub_acceleration;
  Twist reaction = effective.mass * a - effective.force;
  reaction[kRotation] -= effective.centrifugal_inertia * a[kRotation] +
                         2.0 * subsystem.hub->twist[kRotation] * effective.centrifugal_rate;
  return reaction;
}

}  // namespace spoke
