#pragma once

// Quantities that sensors read from a subsystem at the end of a step.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Returns the displacement of a subsystem's tip node from its undeformed place, and its rotation,
/// hub frame [m, m, rad]; poses must be those of the state. Bodies with geometric stiffening are
/// foreshortened.
Twist calc_tip_displacement(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data);

/// Returns the sample of subsystem `i` at the state in the table. Its rotations and twists must be
/// those of the state; the last pass of an implicit step leaves them one correction behind, see
/// update_kinematics(). Calculates its poses.
SubsystemSample<Plane> calc_sample(const System<Plane>& system, std::size_t i,
                                   SubsystemData<Plane>& data) noexcept;
/// The tip of a spatial subsystem is the outermost node of the last body.
SubsystemSample<Space> calc_sample(const System<Space>& system, std::size_t i,
                                   SubsystemData<Space>& data) noexcept;

/// Keeps the sample of subsystem `i` at the end of a step.
template <class World>
void sample_subsystem(const System<World>& system, std::size_t i, std::int64_t step,
                      StepData<World>& data) noexcept {
  SubsystemData<World>& own = data.subsystems[i];
  of_step(own.samples, step) = calc_sample(system, i, own);
}

/// Sets rotations and twists of a subsystem at the state in the table.
void update_kinematics(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data) noexcept;
void update_kinematics(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept;

/// Sets data.root_load, the wrench of the subsystem on the hub, and data.joint_loads, that of each
/// joint on the body outboard of it, in the evaluation that the table holds:
///   root_load = -(F, M) of the first joint + (0, qf^T KG qf alpha0 + 2 w0 qf^T KG qf' + M_T),
/// in the axes of the root bracket; the last term is that of geometric stiffening on the hub's
/// rotation, M_T that of the tension by applied forces and fields, summed over the bodies.
void keep_joint_loads(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data) noexcept;
/// Returns the parts that these loads depend on.
PartList parts_of_joint_loads(const SubsystemData<Plane>& data);
/// Spatial subsystems: data.root_load is the wrench of all bodies on the hub, about the first one's
/// origin, in the hub's frame.
void keep_joint_loads(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept;
PartList parts_of_joint_loads(const SubsystemData<Space>& data);

}  // namespace spoke
