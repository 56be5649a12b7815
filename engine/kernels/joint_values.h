#pragma once

// What the joints of a tree in space show.

#include "engine/table/step_data.h"

namespace spoke {

/// Values of the freedoms of the joints of a tree: for each joint, parents first, those of its
/// primitives in their order, a spherical one's as a rotation vector.
int count_joint_values(const Subsystem<Space>& subsystem);

/// Keeps them at the end of step `step` in the ring. What is prescribed must have been set.
void keep_joint_values(const Subsystem<Space>& subsystem, std::int64_t step,
                       SubsystemData<Space>& data) noexcept;

}  // namespace spoke
