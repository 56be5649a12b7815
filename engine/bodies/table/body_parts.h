#pragma once

// Declares the parts of bodies, as allocate() places their memory. Each world declares its own:
// engine/bodies/plane and engine/bodies/space, body_parts.cpp.

#include <cstddef>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Declare what "position" and "velocity" find besides poses: rotations and twists of all bodies;
/// and the wrenches at their joints, with the accelerations of joints' coordinates that a pass
/// finds.
void declare_motions(SubsystemData<Plane>& data);
void declare_motions(SubsystemData<Space>& data);

/// Add the coordinates of the joint that carries body j to its coordinates, history and
/// accelerations. Planar joints have none.
inline void add_joint_coordinates(std::size_t, SubsystemData<Plane>&) {}
void add_joint_coordinates(std::size_t j, SubsystemData<Space>& data);

/// Declare the terms of body j, and of the joint that carries it, the workspace of kernels, and
/// what the body reports.
void declare_terms(std::size_t j, SubsystemData<Plane>& data);
void declare_terms(std::size_t j, SubsystemData<Space>& data);

}  // namespace spoke
