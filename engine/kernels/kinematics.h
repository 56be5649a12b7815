#pragma once

// Position and velocity analysis of a chain. Bracket joints of a tree are explicit: rotations
// and twists follow outward, body by body, from the hub and the deformations, so the constraints
// hold to round-off and never drift (docs/formulation.md, section 3).

#include "engine/table/step_data.h"

namespace spoke {

/// Place of the outboard handle in the body frame, deformed [m]. The inboard one is the origin.
inline Position calc_outboard_position(const BodyData& body) {
  const double* q = body.coordinates.q;
  return {body.model->body->length + q[body.outboard_at[0]], q[body.outboard_at[1]]};
}
/// Velocity of the outboard handle relative to the body frame [m/s].
inline Position calc_outboard_velocity(const BodyData& body) {
  return {body.coordinates.v[body.outboard_at[0]], body.coordinates.v[body.outboard_at[1]]};
}

/// Foreshortening 1/2 int v'^2 dx of a body with geometric stiffening [m]; 0 of a linear one, whose
/// model has none. The stiffened model accounts for it in its energies, not in its coordinates.
double calc_foreshortening(const BodyData& body) noexcept;

/// Relative rotations along a subsystem, from the deformations.
void calc_rotations(const Subsystem& subsystem, SubsystemData& data) noexcept;

/// Sets the poses of all body frames of a subsystem in the hub frame, from the rotations and
/// deformations.
void calc_poses(const Subsystem& subsystem, const SubsystemData& data,
                ArenaVector<Pose>& poses) noexcept;

/// R_HB of a body, from the rotations.
Rotation calc_rotation_to_hub(const SubsystemData& data, int body) noexcept;

/// Twists of all body frames relative to the inertial frame, each resolved in its body frame.
void calc_velocities(const Subsystem& subsystem, SubsystemData& data) noexcept;

/// Place, orientation and hub-frame twist of the hub from its coordinates.
HubState calc_hub_state(const CoordinateBlock& hub);

}  // namespace spoke
