#pragma once

// Values of the joints of a subsystem in space, as sensors and results show them.

#include "engine/table/step_data.h"

namespace spoke {

/// Counts the freedoms of the joints of a subsystem: for each joint, parents first, those of its
/// primitives in their order, a spherical one's as a rotation vector.
int count_joint_values(const Subsystem<Space>& subsystem);

/// Keeps their values at the end of step `step` in the ring. Prescribed motions must have been set.
void keep_joint_values(const Subsystem<Space>& subsystem, std::int64_t step,
                       SubsystemData<Space>& data) noexcept;

}  // namespace spoke
