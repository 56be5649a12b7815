#pragma once

// The force on an interface of a solid.

#include <cstddef>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Returns force and moment that all that is joined to the interface of a reading exerts on the
/// solid, and loads on the interface, about its point; in the frame of the solid. At the first
/// interface it is the reaction of the joint inboard, with what loops and loads exert there. Poses
/// and rotations of the table must be those of the state, joint_loads and multipliers those of its
/// step; t: its time [s].
space::Twist calc_interface_force(const System<Space>& system, std::size_t i, double t,
                                  const Reading<Space>& reading,
                                  const StepData<Space>& data) noexcept;

}  // namespace spoke
