#pragma once

// The hub's equation of motion, (P 9): docs/formulation.md, section 4.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Solves the hub's equation of motion (P 9) in the hub frame:
///   (M_0 + sum M^C - centrifugal) Y'' = Q_0 + sum Q^C + reaction,
/// with the acceleration of prescribed components given and their reaction unknown, those of free
/// components unknown. Uniform gravity acts on all bodies as an acceleration of the frame, so the
/// translational unknown is a - g throughout the system. Subsystems are summed in their order.
template <class World>
void solve_hub(const System<World>& system, StepData<World>& data) noexcept;
/// Returns the parts that its solution depends on.
template <class World>
PartList parts_of_hub_solution(const StepData<World>& data);

/// Returns the wrench of the loads on the hub at time t [s], about its axis, hub frame [N, N m].
template <class World>
TwistOf<World> calc_hub_load(const System<World>& system, double t,
                             const HubState<World>& hub) noexcept;

/// Sets the torque of the drive and the wrench of the loads on the hub in the solution.
template <class World>
void set_applied(const System<World>& system, StepData<World>& data) noexcept;

/// Returns Q_0 of (P 9): drive, loads and the forces of the hub's own inertia.
template <class World>
TwistOf<World> calc_hub_force(const typename World::Hub& hub, const HubState<World>& state,
                              const HubSolution<World>& applied) noexcept;

/// Effective inertia of the hub with all subsystems, and the right-hand side, hub frame. Drive and
/// loads on the hub must have been set.
template <class World>
struct HubEquation {
  TwistMatrixOf<World> mass;
  TwistOf<World> force;
};
template <class World>
HubEquation<World> sum_hub_equation(const System<World>& system,
                                    const StepData<World>& data) noexcept;

/// Returns the terms of geometric stiffening in the hub's equation, summed over the bodies.
template <class World>
typename BodyTypes<World>::HubStiffening sum_stiffening(
    const ArenaVector<BodyData<World>>& bodies) noexcept {
  typename BodyTypes<World>::HubStiffening sum;
  for (const BodyData<World>& body : bodies) sum += body.terms.stiffening;
  return sum;
}

/// Returns the share of one subsystem in the hub's reaction of (P 9): M^C Y'' - Q^C less the
/// centrifugal terms, at the acceleration that the subsystem has felt; hub frame.
template <class World>
TwistOf<World> calc_reaction(const SubsystemData<World>& subsystem) noexcept;

}  // namespace spoke
