#pragma once

// The nodes with which a pass ends: what the integrator makes of it, and the sensors.

#include "engine/step/assembly.h"

namespace spoke {

/// Ends the pass of the system.
template <class World>
void add_finish(const Assembly<World>& g);
/// Ends the pass of blade `i`, with its own progress.
template <class World>
void add_subsystem_finish(const Assembly<World>& g, int i);
/// What the sensors show of blade `i`, if the pass has completed a step that is observed.
template <class World>
void add_sensors(const Assembly<World>& g, int i);

}  // namespace spoke
