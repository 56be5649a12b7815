#pragma once

// The numbers that make up a state, in their fixed order: these are saved and hashed.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/bodies/table/step_data.h"

namespace spoke {

// The state is what the end of a step leaves to the next step and to the sensors, as a list of
// doubles whose order depends on the model, formulation and method only: hub coordinates with their
// histories, hub motion, the step's record, the power at the end of the step by every progress;
// then by subsystem the prescribed hub, the loads of its root and its joints, the states of the air
// on it, what it found there for sensors, the states of its controllers, and of each body
// coordinates, velocities, accelerations and histories as flex vectors. All else in the table a
// pass recalculates, or follows from the number of the step.

/// Number of doubles in the state.
template <class World>
std::size_t count_state_values(StepData<World>& data);

/// Returns the values at the end of step `step`. StepTable::put_state() puts as many back.
std::vector<double> take_state_values(std::int64_t step, StepTable& data);

/// Returns the places of the values of subsystem `i`.
template <class World>
std::vector<std::span<std::byte>> state_of_subsystem(StepData<World>& data, std::size_t i);

/// Returns a hash (FNV-1a, 64 bits) of all coordinates and velocities, to compare runs bit by bit.
template <class World>
std::uint64_t hash_state(const StepData<World>& data);

}  // namespace spoke
