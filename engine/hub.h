#pragma once

#include "engine/step_data.h"

namespace spoke {

/// Solves the hub's equation of motion (P 9) in the hub frame:
///   (M_0 + sum M^C - centrifugal) Y'' = Q_0 + sum Q^C + reaction,
/// with the acceleration of prescribed components given and their reaction unknown, those of free
/// components unknown. Uniform gravity acts on all bodies as an acceleration of the frame, so the
/// translational unknown is a - g throughout the system. Subsystems are summed in their order.
void solve_hub(const System& system, StepData& data) noexcept;

/// Effective inertia of the hub with all subsystems and its right-hand side, hub frame.
struct HubEquation {
  TwistMatrix mass;
  Twist force;
};
HubEquation sum_hub_equation(const System& system, const StepData& data) noexcept;

/// Acceleration of a subsystem's root bracket, less gravity, resolved in its first body's frame,
/// from which R_HB leads to the hub frame.
Twist calc_root_acceleration(const Subsystem& subsystem, const HubState& hub,
                             const Twist& hub_acceleration, const Rotation& R_HB);

/// The acceleration of the hub in the inertial frame from its solution (a - g, hub frame).
Twist calc_inertial_acceleration(const System& system, const HubState& hub,
                                 const HubSolution& solution);

/// Acceleration of the hub that the support and the drive prescribe, less gravity, in the hub
/// frame; components that are not prescribed are zero. `alpha`: the drive's [rad/s^2].
Twist calc_prescribed_acceleration(const System& system, const Rotation& R, double alpha);

/// Sets position, velocity and acceleration of the hub's prescribed components at time t [s].
void impose_hub_motion(const System& system, double t, CoordinateBlock& hub) noexcept;

/// The whole motion of a hub that support and drive prescribe, at time t [s].
PrescribedHub calc_prescribed_motion(const System& system, double t) noexcept;

/// Share of one subsystem in the hub's reaction of (P 9): M^C Y'' - Q^C less the centrifugal terms,
/// at the acceleration that the subsystem has felt; hub frame.
Twist calc_reaction(const SubsystemData& subsystem) noexcept;

/// Whether support and drive prescribe the whole motion of the hub. The solution of (P 9) is then
/// known but for the reaction, which no motion depends on.
bool is_prescribed(const Hub& hub);

}  // namespace spoke
