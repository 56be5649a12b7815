// Sums the subsystems' effective inertias and solves for the free components and the reactions.

#include "engine/bodies/kernels/hub_solve.h"

#include <Eigen/LU>
#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"

namespace spoke {

template <class World>
TwistOf<World> calc_hub_load(const System<World>& system, double t,
                             const HubState<World>& hub) noexcept {
  TwistOf<World> sum = TwistOf<World>::Zero();
  for (const typename World::HubLoad& load : system.hub_loads) {
    const double factor = load.factor.value(t) * calc_rise(t, load.ramp);
    TwistOf<World> wrench = make_wrench(load.force, moment_of(load));
    if (load.frame == LoadFrame::inertial) wrench = hub.R.inverse() * wrench;
    sum += factor * translate(load.position, wrench);
  }
  return sum;
}

template <class World>
void set_applied(const System<World>& system, StepData<World>& data) noexcept {
  const double t = data.progress[0].control.time;
  data.hub_solution.applied_torque =
      calc_torque(system.hub.drive, t, data.hub.twist[World::kAxial]);
  data.hub_solution.load = calc_hub_load(system, t, data.hub);
}

template <class World>
TwistOf<World> calc_hub_force(const typename World::Hub& hub, const HubState<World>& state,
                              const HubSolution<World>& applied) noexcept {
  TwistOf<World> force = applied.load;
  force[World::kAxial] += applied.applied_torque;
  add_gyroscopic_force(hub, state.twist, force);
  return force;
}

template <class World>
HubEquation<World> sum_hub_equation(const System<World>& system,
                                    const StepData<World>& data) noexcept {
  // (1) M_0 + sum M^C - centrifugal inertia, and Q_0 + sum Q^C + centrifugal moment.
  HubEquation<World> sum;
  sum.mass = calc_hub_mass(system.hub);
  sum.force = calc_hub_force(system.hub, data.hub, data.hub_solution);
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    if (subsystem.rotor >= 0) continue;  // its rotor's hub has it
    const EffectiveInertia<World>& effective = subsystem.effective;
    sum.mass += effective.mass;
    sum.force += effective.force;
    rotary(sum.mass) -= effective.stiffening.inertia;
    angular(sum.force) += calc_stiffening_moment(effective.stiffening, angular(data.hub.twist));
  }
  if (!data.shared_loops.rows.is_empty()) {
    sum.mass += data.shared_loops.mass;
    sum.force += data.shared_loops.force;
  }
  return sum;
}

template <class World>
void solve_hub(const System<World>& system, StepData<World>& data) noexcept {
  set_applied(system, data);
  const HubEquation<World> equation = sum_hub_equation(system, data);
  const TwistOf<World> given = calc_prescribed_acceleration(
      system, data.progress[0].control.time, data.hub, data.hub_coordinates.a[World::kAxial]);
  // (2) A prescribed component is given: its row becomes that of the identity.
  TwistMatrixOf<World> matrix = equation.mass;
  TwistOf<World> right = equation.force;
  int prescribed = 0;
  for (int c = 0; c < World::kTwist; ++c) {
    if (!is_prescribed(system.hub, c)) continue;
    matrix.row(c) = TwistOf<World>::Unit(c);
    right[c] = given[c];
    ++prescribed;
  }
  HubSolution<World>& solution = data.hub_solution;
  solution.acceleration = right;
  if (prescribed < World::kTwist) solution.acceleration = matrix.partialPivLu().solve(right);
  // (3) The reaction is the residual of the equation; it is zero for free components.
  solution.reaction = equation.mass * solution.acceleration - equation.force;
  for (int c = 0; c < World::kTwist; ++c)
    if (!is_prescribed(system.hub, c)) solution.reaction[c] = 0.0;
}

template <class World>
PartList parts_of_hub_solution(const StepData<World>& data) {
  PartList list{data.parts.hub_state, data.parts.hub_coordinates};
  for (const SubsystemData<World>& subsystem : data.subsystems)
    if (subsystem.rotor < 0) list.push_back(subsystem.parts.effective);
  return list;
}

template <class World>
TwistOf<World> calc_reaction(const SubsystemData<World>& subsystem) noexcept {
  assert(subsystem.hub_acceleration);
  const EffectiveInertia<World>& effective = subsystem.effective;
  const TwistOf<World>& a = *subsystem.hub_acceleration;
  TwistOf<World> reaction = effective.mass * a - effective.force;
  angular(reaction) -= effective.stiffening.inertia * angular(a) +
                       calc_stiffening_moment(effective.stiffening, angular(subsystem.hub->twist));
  return reaction;
}

template Twist calc_hub_load(const System<Plane>&, double, const HubState<Plane>&) noexcept;
template void set_applied(const System<Plane>&, StepData<Plane>&) noexcept;
template Twist calc_hub_force(const Hub&, const HubState<Plane>&,
                              const HubSolution<Plane>&) noexcept;
template HubEquation<Plane> sum_hub_equation(const System<Plane>&, const StepData<Plane>&) noexcept;
template void solve_hub(const System<Plane>&, StepData<Plane>&) noexcept;
template PartList parts_of_hub_solution(const StepData<Plane>&);
template Twist calc_reaction(const SubsystemData<Plane>&) noexcept;
template space::Twist calc_hub_load(const System<Space>&, double, const HubState<Space>&) noexcept;
template void set_applied(const System<Space>&, StepData<Space>&) noexcept;
template space::Twist calc_hub_force(const space::Hub&, const HubState<Space>&,
                                     const HubSolution<Space>&) noexcept;
template HubEquation<Space> sum_hub_equation(const System<Space>&, const StepData<Space>&) noexcept;
template void solve_hub(const System<Space>&, StepData<Space>&) noexcept;
template PartList parts_of_hub_solution(const StepData<Space>&);
template space::Twist calc_reaction(const SubsystemData<Space>&) noexcept;

}  // namespace spoke
