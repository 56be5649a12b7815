#pragma once

// Values of the joints of a subsystem in space and of actors on it, as sensors and results show
// them.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Counts the freedoms of the joints of a subsystem: for each joint, parents first, those of its
/// primitives in their order, a spherical one's as a rotation vector.
int count_joint_values(const Subsystem<Space>& subsystem);

/// Keeps these values of subsystem `i` at the end of step `step`, at time t [s], in its ring, and
/// behind them what actors keep. Prescribed motions must have been set.
void keep_own_values(std::size_t i, std::int64_t step, double t, StepData<Space>& data) noexcept;
/// Counts what is kept of subsystem `i`.
std::size_t count_own_values(const System<Space>& system, std::size_t i,
                             const StepData<Space>& data);

}  // namespace spoke
