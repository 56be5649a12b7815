#pragma once

// What the sensors need of a tree in space at the end of a step.

#include "engine/table/step_data.h"

namespace spoke {

/// See samples.h. The tip is the outermost node of the last body.
SubsystemSample<Space> calc_sample(const System<Space>& system, std::size_t i,
                                   SubsystemData<Space>& data) noexcept;
void update_kinematics(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept;

/// Keeps what each joint does to the body that it carries, in its frame, and to data.root_load what
/// all bodies on the hub do to it: about the first one's origin, in the hub's frame.
void keep_joint_loads(const Subsystem<Space>& subsystem, SubsystemData<Space>& data) noexcept;

}  // namespace spoke
