#pragma once

// What the sensors need of a blade at the end of a step.

#include "engine/table/step_data.h"

namespace spoke {

/// Displacement of a subsystem's tip node from its undeformed place, and its rotation, hub frame
/// [m, m, rad]; poses must be those of the state. Bodies with geometric stiffening are
/// foreshortened.
Twist calc_tip_displacement(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data);

/// What the sensors show of subsystem `i` at the state in the table. Its rotations and twists must
/// be those of the state; the last pass of an implicit step leaves them one correction behind, see
/// update_kinematics(). Calculates its poses.
SubsystemSample<Plane> calc_sample(const System<Plane>& system, std::size_t i,
                                   SubsystemData<Plane>& data) noexcept;

/// Rotations and twists of a subsystem at the state in the table.
void update_kinematics(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data) noexcept;

}  // namespace spoke
