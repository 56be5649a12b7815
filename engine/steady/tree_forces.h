#pragma once

// Generalised forces of a tree at a state without accelerations: what its coordinates and the hub
// feel, the forces of inertia at zero accelerations among it. F = M a of the accelerations that the
// formulations find (docs/modes.md).

#include "engine/steady/steady_model.h"
#include "engine/table/step_data.h"

namespace spoke::steady {

/// Sets the accelerations of all frames for coordinates without any, and the hub's as it is, from
/// the hub to the tips; then sums forces from the tips to the hub. Kinematics and terms in the
/// table must be those of the state.
void calc_forces(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data,
                 TreeResponse& response);
void calc_forces(const Subsystem<Space>& subsystem, SubsystemData<Space>& data,
                 TreeResponse& response);

}  // namespace spoke::steady
