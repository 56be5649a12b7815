#pragma once

// The actors that a scenario has.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Puts the actors of a system on its table, which is allocated. Bodies sum up wrenches in this
/// order.
void place_actors(const System<Plane>& system, StepData<Plane>& data);
void place_actors(const System<Space>& system, StepData<Space>& data);

/// Counts the values of sensors that they will keep of a subsystem in each step.
std::size_t count_actor_values(const Subsystem<Space>& subsystem);

}  // namespace spoke
