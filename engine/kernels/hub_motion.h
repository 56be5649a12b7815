#pragma once

// Motion of the hub and of the root brackets on it: what support and drive prescribe, and the same
// acceleration in other frames (docs/formulation.md, sections 1 and 3).

#include "engine/table/step_data.h"

namespace spoke {

/// Acceleration of a subsystem's root bracket, less gravity, resolved in its first body's frame,
/// from which R_HB leads to the hub frame.
Twist calc_root_acceleration(const Subsystem& subsystem, const HubState& hub,
                             const Twist& hub_acceleration, const Rotation& R_HB);

/// The acceleration of the hub in the inertial frame from its solution (a - g, hub frame) at time
/// t [s].
Twist calc_inertial_acceleration(const System& system, double t, const HubState& hub,
                                 const HubSolution& solution);

/// Acceleration of the hub that the support and the drive prescribe, less gravity, in the hub
/// frame, at time t [s]; components that are not prescribed are zero. `alpha`: the drive's
/// [rad/s^2].
Twist calc_prescribed_acceleration(const System& system, double t, const Rotation& R, double alpha);

/// Sets position, velocity and acceleration of the hub's prescribed components at time t [s].
void impose_hub_motion(const System& system, double t, CoordinateBlock& hub) noexcept;

/// The whole motion of a hub that support and drive prescribe, at time t [s].
PrescribedHub calc_prescribed_motion(const System& system, double t) noexcept;

/// Whether support and drive prescribe the whole motion of the hub. The solution of (P 9) is then
/// known but for the reaction, which no motion depends on.
bool is_prescribed(const Hub& hub);

}  // namespace spoke
