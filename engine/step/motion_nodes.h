#pragma once

// The nodes with which a pass begins: motion of the hub, coordinates, position and velocity
// analysis, loads of the user's.

#include "engine/step/assembly.h"

namespace spoke {

/// The hub's motion where it has a free coordinate, or is solved for with all else.
template <class World>
void add_hub_motion(const Assembly<World>& g);
/// The hub's motion as blade `i` follows it, where it is prescribed.
template <class World>
void add_prescribed_hub_motion(const Assembly<World>& g, int i);
/// The coordinates that the integrator sets for the pass.
template <class World>
void add_coordinates(const Assembly<World>& g, int i);
/// Rotations of the bodies.
template <class World>
void add_position(const Assembly<World>& g, int i);
/// Twists of the bodies; their poses only where drag depends on them.
template <class World>
void add_velocity(const Assembly<World>& g, int i);
/// Loads whose first blade this is. A load between blades is a node of no blade.
template <class World>
void add_loads_of_user(const Assembly<World>& g, int i);
/// The sums of applied forces along a blade, where tension depends on them.
template <class World>
void add_applied_forces(const Assembly<World>& g, int i);
/// Of a hub that flies: what they accelerate its mass centre by, likewise.
template <class World>
void add_flight_acceleration(const Assembly<World>& g);

}  // namespace spoke
