#pragma once

// The numbers that make up a state, in their fixed order: what is saved, and what state_hash is of.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/table/step_data.h"

namespace spoke {

// The state is what the end of a step leaves to the next step and to the sensors, as a list of
// doubles whose order depends on the model, formulation and method only: hub coordinates with their
// histories, hub motion, the step's record, the power at the end of the step by every progress;
// then by subsystem the prescribed hub, the loads of its root and its joints, and of each body
// coordinates, velocities, accelerations and histories as flex vectors. All else in the table a
// pass recalculates, or follows from the number of the step.

/// Number of doubles in the state.
std::size_t count_state_values(StepData& data);

/// Copies the state at the end of step `step`; `values` keeps its memory.
void take_state_values(std::int64_t step, StepData& data, std::vector<double>& values);
std::vector<double> take_state_values(std::int64_t step, StepData& data);

/// Sets the table to a state that was taken at the end of step `step`. All else of the progress is
/// left to TimeStepper::continue_from(). Precondition: values.size() == count_state_values(data).
void put_state_values(std::span<const double> values, std::int64_t step, StepData& data);

/// A hash (FNV-1a, 64 bits) of all coordinates and velocities, to compare runs bit by bit.
std::uint64_t hash_state(const StepData& data);

}  // namespace spoke
