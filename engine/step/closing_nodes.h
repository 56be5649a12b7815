#pragma once

// The nodes with which a pass ends: the integrator takes its results, and the sensors read them.

#include "engine/step/assembly.h"

namespace spoke {

/// Adds the node that ends the pass of the system.
template <class World>
void add_finish(const Assembly<World>& g);
/// Adds the node that ends the pass of subsystem `i`, with its own progress.
template <class World>
void add_subsystem_finish(const Assembly<World>& g, int i);
/// Adds the node that samples subsystem `i` for the sensors, if the pass has completed a step that
/// is observed.
template <class World>
void add_sensors(const Assembly<World>& g, int i);

}  // namespace spoke
