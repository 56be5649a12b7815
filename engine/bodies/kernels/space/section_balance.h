#pragma once

// Forces in a beam by the balance of its outboard part (engine/bodies/kinds/beam), and the momentum
// of a subsystem.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Returns the load of the part outboard of a reading's section on the part inboard: force [N] and
/// moment about the deformed section [N m], in the frame of the section's body. The balance of the
/// body's own part outboard is
///   N = sum of (forces of the joints that it carries) + (applied forces) - int rho'' dm,
/// with rho'' less gravity; moments likewise. Loads, masses and joints at the section count as
/// outboard. Rotations and twists of the table must be those of the state, joint_loads those of its
/// step; t: its time [s]. `X`: of the section's body, which is a beam.
space::Twist calc_section_load(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                               double t, const space::Twist& X,
                               const Reading<Space>& reading) noexcept;

/// Returns linear momentum [kg m/s] and angular momentum about the inertial origin [kg m^2/s] of a
/// subsystem, with the terms of geometric stiffening; inertial frame. Poses and twists of the table
/// must be those of the state.
space::Twist calc_momentum(const SubsystemData<Space>& data) noexcept;

}  // namespace spoke
