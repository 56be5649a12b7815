#pragma once

// Position and velocity analysis of a chain. Bracket joints of a tree are explicit: rotations
// and twists follow outward, body by body, from the hub and the deformations, so the constraints
// hold to round-off and never drift (docs/formulation.md, section 3).

#include "engine/kernels/planar_handles.h"
#include "engine/table/step_data.h"

namespace spoke {

/// Relative rotations along a subsystem, from the deformations.
template <class World>
void calc_rotations(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept;

/// Sets the poses of all body frames of a subsystem in the hub frame, from the rotations and
/// deformations.
template <class World>
void calc_poses(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                ArenaVector<PoseOf<World>>& poses) noexcept;

/// R_HB of a body, from the rotations.
template <class World>
RotationOf<World> calc_rotation_to_hub(const SubsystemData<World>& data, int body) noexcept;

/// Twists of all body frames relative to the inertial frame, each resolved in its body frame.
template <class World>
void calc_velocities(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept;

/// Place, orientation and hub-frame twist of the hub from its coordinates.
template <class World>
HubState<World> calc_hub_state(const CoordinateBlock& hub);

}  // namespace spoke
