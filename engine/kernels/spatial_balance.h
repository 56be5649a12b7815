#pragma once

// Forces in a tree in space by the balance of what is outboard, and its momentum: sums over slots
// and their masses.

#include "engine/table/step_data.h"

namespace spoke {

/// What the part outboard of a reading's section does to the part inboard: force [N] and moment
/// about the deformed section [N m], in the frame of the section's body. Of the body's own part
/// outboard,
///   N = sum of (forces of the joints that it carries) + (applied forces) - int rho'' dm,
/// rho'' less gravity; moments likewise. Loads, masses and joints at the section count as outboard.
/// Rotations and twists of the table must be those of the state, joint_loads those of its step; t:
/// its time [s]. `X`: of the section's body.
space::Twist calc_section_load(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                               double t, const space::Twist& X,
                               const Reading<Space>& reading) noexcept;

/// Linear momentum [kg m/s] and angular momentum about the inertial origin [kg m^2/s] of a tree,
/// with the terms of geometric stiffening; inertial frame. Poses and twists of the table must be
/// those of the state.
space::Twist calc_momentum(const SubsystemData<Space>& data) noexcept;

}  // namespace spoke
