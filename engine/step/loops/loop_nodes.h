#pragma once

// The nodes of closed loops (docs/formulation.md, section 12): of subsystems that have some.

#include "engine/step/assembly.h"

namespace spoke {

/// Adds the node that finds openings and what is to close them, behind "velocity".
template <class World>
void add_loop_motion(const Assembly<World>& g, int i);

/// Adds the node of the motion of loops between subsystems, behind that of all subsystems' loops.
template <class World>
void add_shared_loop_motion(const Assembly<World>& g);

/// Adds the nodes between the effective inertia of a subsystem's tree and the hub: one for each
/// loop, then one for all.
template <class World>
void add_loop_factor(const Assembly<World>& g, int i);

/// Adds the node between the hub and the multipliers of joints.
template <class World>
void add_loop_forces(const Assembly<World>& g, int i);

}  // namespace spoke
