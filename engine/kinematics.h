#pragma once

// Position and velocity analysis of a chain. Bracket joints of a tree are explicit: poses and twists
// follow outward, body by body, from the hub and the deformations, so the constraints hold to
// round-off and never drift (docs/formulation.md, section 3).

#include "engine/step_data.h"

namespace spoke {

/// Place of a handle in the body frame, deformed [m].
Position calc_handle_position(const Handle& handle, const double* q, const FlexLayout& layout);
/// Velocity of a handle relative to the body frame [m/s].
Position calc_handle_velocity(const Handle& handle, const double* v, const FlexLayout& layout);
/// Rotation of a handle (or its rate) relative to the body frame [rad, rad/s]; `q` may be the
/// velocities.
double handle_rotation(const Handle& handle, const double* q, const FlexLayout& layout);

/// Where coordinate `index` of the order "axial, then bending" stands in a flex vector.
inline int flex_index(int index, const FlexLayout& layout) {
  return index < layout.axial ? layout.u() + index : layout.v() + (index - layout.axial);
}

/// Poses of all body frames of a subsystem in the hub frame, from the deformations.
void calc_positions(const Subsystem& subsystem, SubsystemData& data) noexcept;

/// Twists of all body frames relative to the inertial frame, each resolved in its body frame.
void calc_velocities(const Subsystem& subsystem, const HubState& hub, SubsystemData& data) noexcept;

/// Orientation and hub-frame twist of the hub from its coordinates.
HubState calc_hub_state(const CoordinateBlock& hub);

/// Place of a node in the body frame, deformed [m]. Precondition: 0 <= node <= elements.
Position calc_node_position(const FlexibleBody& body, int node, const double* q,
                            const FlexLayout& layout);

}  // namespace spoke
