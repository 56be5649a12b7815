#pragma once

// Values of the scenario's sensors on one subsystem.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Measures the sensors of subsystem `i` at the end of step `step`, time t [s], into its ring.
/// Poses, also those of the loops, and twists must be those of the state, loads of joints and loops
/// those of the step. Accelerations are those that the integrator keeps.
void calc_readings(const System<Plane>& system, std::size_t i, std::int64_t step, double t,
                   StepData<Plane>& data) noexcept;
void calc_readings(const System<Space>& system, std::size_t i, std::int64_t step, double t,
                   StepData<Space>& data) noexcept;
/// Return the parts that they depend on beyond these places, twists and loads, and what actors
/// show.
PartList parts_of_readings(std::size_t i, const StepData<Plane>& data);
PartList parts_of_readings(std::size_t i, const StepData<Space>& data);

}  // namespace spoke
