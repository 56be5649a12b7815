#pragma once

// The hub's equation of motion, (P 9): docs/formulation.md, section 4.

#include "engine/table/step_data.h"

namespace spoke {

/// Solves the hub's equation of motion (P 9) in the hub frame:
///   (M_0 + sum M^C - centrifugal) Y'' = Q_0 + sum Q^C + reaction,
/// with the acceleration of prescribed components given and their reaction unknown, those of free
/// components unknown. Uniform gravity acts on all bodies as an acceleration of the frame, so the
/// translational unknown is a - g throughout the system. Subsystems are summed in their order.
void solve_hub(const System& system, StepData& data) noexcept;

/// What the loads on the hub do to it at time t [s], about its axis, hub frame [N, N m].
Twist calc_hub_load(const System& system, double t, const HubState& hub) noexcept;

/// Sets in the solution what the drive and the loads apply to the hub.
void set_applied(const System& system, StepData& data) noexcept;

/// Both together: Q_0 of (P 9).
Twist calc_hub_force(const HubSolution& applied) noexcept;

/// Effective inertia of the hub with all subsystems and its right-hand side, hub frame. What is
/// applied to the hub must have been set.
struct HubEquation {
  TwistMatrix mass;
  Twist force;
};
HubEquation sum_hub_equation(const System& system, const StepData& data) noexcept;

/// Share of one subsystem in the hub's reaction of (P 9): M^C Y'' - Q^C less the centrifugal terms,
/// at the acceleration that the subsystem has felt; hub frame.
Twist calc_reaction(const SubsystemData& subsystem) noexcept;

}  // namespace spoke
