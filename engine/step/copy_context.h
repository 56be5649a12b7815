#pragma once

// Copies of a context, which go on from its state by themselves.

#include <cstdint>

#include "engine/step/step_context.h"

namespace spoke {

/// Begins a copy: `copy`, which is new, gets the method and a system of its own, in which the
/// motions, loads and wind are those in force. Bodies, air, wind and the formulation's constants
/// are shared, which nothing changes.
template <class World>
void begin_copy(const SystemContext<World>& original, SystemContext<World>& copy);

/// Gives an allocated copy the readings of the scenario's sensors, whose constants are shared, and
/// rings for them.
template <class World>
void copy_readings(const SystemContext<World>& original, SystemContext<World>& copy);

/// Ends a copy that is allocated with as many records: puts the loops and the state at the end of
/// step `steps`, at which `original` stands, into its table. Values of readings and samples are
/// left as they are.
template <class World>
void end_copy(SystemContext<World>& original, std::int64_t steps, SystemContext<World>& copy);

}  // namespace spoke
