#pragma once

// The nodes with which a pass begins: motion of the hub, coordinates, position and velocity
// analysis, and the sums of what is applied.

#include "engine/step/assembly.h"

namespace spoke {

/// Adds the node of the hub's motion where it has a free coordinate, or is solved for with all
/// else.
template <class World>
void add_hub_motion(const Assembly<World>& g);
/// Of the hub of a rotor on a support, behind the support's velocity.
template <class World>
void add_rotor_motion(const Assembly<World>& g, int r);
/// Adds the node of the hub's motion as subsystem `i` follows it, where it is prescribed.
template <class World>
void add_prescribed_hub_motion(const Assembly<World>& g, int i);
/// Adds the node in which the integrator sets the coordinates for the pass.
template <class World>
void add_coordinates(const Assembly<World>& g, int i);
/// Adds the node of the bodies' rotations.
template <class World>
void add_position(const Assembly<World>& g, int i);
/// Adds the node of the bodies' twists, and of their poses only where drag depends on them.
template <class World>
void add_velocity(const Assembly<World>& g, int i);
/// Adds the node that sums the applied forces along a subsystem, where tension depends on them.
template <class World>
void add_applied_forces(const Assembly<World>& g, int i);
/// Adds the node of the acceleration that the applied forces give the mass centre of a hub that
/// flies, where tension depends on it.
template <class World>
void add_flight_acceleration(const Assembly<World>& g);

}  // namespace spoke
