#pragma once

// Values of the joints and controllers of a subsystem in space, as sensors and results show them.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Counts the freedoms of the joints of a subsystem: for each joint, parents first, those of its
/// primitives in their order, a spherical one's as a rotation vector.
int count_joint_values(const Subsystem<Space>& subsystem);

/// Values of a controller, in the order of its columns: demand [rad], angle [rad], rate [rad/s].
inline constexpr int kControlValues = 3;

/// Counts the values of a subsystem's joints, and of its controllers behind them.
int count_own_values(const Subsystem<Space>& subsystem);

/// Keeps these values at the end of step `step`, at time t [s], in the ring. Prescribed motions
/// must have been set.
void keep_own_values(std::int64_t step, double t, SubsystemData<Space>& data) noexcept;

}  // namespace spoke
