#pragma once

// The node of a pass in which controllers take their samples.

#include "engine/step/assembly.h"

namespace spoke {

/// Returns the part of the controllers of subsystem `i`; none if it has no controllers.
template <class World>
PartList controls_of(const Assembly<World>& g, int i);

/// Adds the node of the controllers of subsystem `i`, if it has any. In the first pass of a step it
/// reads the speed of the hub as the last step has left it: it stands before all nodes that change
/// the hub's motion.
template <class World>
void add_control(const Assembly<World>& g, int i);

}  // namespace spoke
