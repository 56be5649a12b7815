#pragma once

// Generalised forces of a subsystem at a state without accelerations: the forces on its coordinates
// and on the hub, including those of inertia at zero accelerations. For the accelerations a that
// the formulations find, F = M a (docs/modes.md).

#include "engine/steady/steady_model.h"
#include "engine/table/step_data.h"

namespace spoke::steady {

/// Sets the accelerations of all frames from the hub to the tips, for coordinates without
/// accelerations and the hub's as it is; then sums forces from the tips to the hub. Precondition:
/// kinematics and terms in the table are those of the state.
void calc_forces(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data,
                 SubsystemResponse& response);
void calc_forces(const Subsystem<Space>& subsystem, SubsystemData<Space>& data,
                 SubsystemResponse& response);

}  // namespace spoke::steady
