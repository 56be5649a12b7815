#pragma once

#include <cstdint>
#include <vector>

#include "engine/step_data.h"

namespace spoke {

/// Calls `apply` with each range of doubles that the end of step `step` leaves to the next step and
/// to the sensors, in an order that depends on the model, formulation and method only: hub
/// coordinates with their histories, hub motion, the step's record, the power at every clock; then
/// by subsystem the prescribed hub, and of each body coordinates, velocities, accelerations and
/// histories as flex vectors. All else in the table a pass recalculates, or follows from `step`.
template <class Apply>
void for_each_state_part(std::int64_t step, StepData& data, Apply&& apply) {
  apply(doubles(data.hub_storage[0], data.hub_storage.size()));
  apply(doubles(data.hub));
  apply(doubles(of_step(data.records, step)));
  for (Clock& clock : data.clocks) apply(doubles(clock.power));
  for (SubsystemData& subsystem : data.subsystems) {
    apply(doubles(subsystem.prescribed));
    for (BodyData& body : subsystem.bodies) {
      const CoordinateBlock& block = body.coordinates;
      const auto size = static_cast<std::size_t>(block.size);
      for (double* vector : {block.q, block.v, block.a}) apply(std::span(vector, size));
      for (double* vector : block.history)
        if (vector) apply(std::span(vector, size));
    }
  }
}

/// Number of doubles in the state.
std::size_t count_state_values(StepData& data);

/// Copies the state at the end of step `step`; `values` keeps its memory.
void take_state_values(std::int64_t step, StepData& data, std::vector<double>& values);
std::vector<double> take_state_values(std::int64_t step, StepData& data);

/// Sets the table to a state that was taken at the end of step `step`. The clocks are left to
/// TimeStepper::continue_from(). Precondition: values.size() == count_state_values(data).
void put_state_values(const std::vector<double>& values, std::int64_t step, StepData& data);

/// A hash (FNV-1a, 64 bits) of all coordinates and velocities, to compare runs bit by bit.
std::uint64_t hash_state(const StepData& data);

}  // namespace spoke
