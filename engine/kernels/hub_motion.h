#pragma once

// Motion of the hub and of the root brackets on it: what support and drive prescribe, and the same
// acceleration in other frames (docs/formulation.md, sections 1 and 3).

#include "engine/table/step_data.h"

namespace spoke {

/// Acceleration of a subsystem's root bracket where the hub's is zero, hub frame.
template <class World>
TwistOf<World> calc_bracket_bias(const Subsystem<World>& subsystem, const HubState<World>& hub);

/// Acceleration of a subsystem's root bracket, less gravity, resolved in its first body's frame,
/// from which R_HB leads to the hub frame.
template <class World>
TwistOf<World> calc_root_acceleration(const Subsystem<World>& subsystem, const HubState<World>& hub,
                                      const TwistOf<World>& hub_acceleration,
                                      const RotationOf<World>& R_HB);

/// The acceleration of the hub in the inertial frame from its solution (a - g, hub frame) at time
/// t [s].
template <class World>
TwistOf<World> calc_inertial_acceleration(const System<World>& system, double t,
                                          const HubState<World>& hub,
                                          const HubSolution<World>& solution);

/// Acceleration of the hub that the support and the drive prescribe, less gravity, in the hub
/// frame, at time t [s]; components that are not prescribed are zero. `alpha`: the drive's
/// [rad/s^2].
template <class World>
TwistOf<World> calc_prescribed_acceleration(const System<World>& system, double t,
                                            const RotationOf<World>& R, double alpha);

/// Sets position, velocity and acceleration of the hub's prescribed components at time t [s].
template <class World>
void impose_hub_motion(const System<World>& system, double t, CoordinateBlock& hub) noexcept;

/// The whole motion of a hub that support and drive prescribe, at time t [s].
template <class World>
PrescribedHub<World> calc_prescribed_motion(const System<World>& system, double t) noexcept;

/// Whether support and drive prescribe the whole motion of the hub. The solution of (P 9) is then
/// known but for the reaction, which no motion depends on.
template <class World>
bool is_prescribed(const System<World>& system);

}  // namespace spoke
