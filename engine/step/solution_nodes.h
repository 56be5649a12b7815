#pragma once

// The nodes between the terms of the bodies and the end of a pass: those of the formulation.

#include "engine/step/assembly.h"

namespace spoke {

/// Adds the node that condenses body `j` of subsystem `i` to its handles, or inverts its mass
/// matrix, (P 11).
template <class World>
void add_inverse(const Assembly<World>& g, int i, int j);
/// Adds the node of effective mass and force of subsystem `i`, (P 10).
template <class World>
void add_effective(const Assembly<World>& g, int i);
/// Adds the node of (P 9) where the hub has a free coordinate: once in each pass.
template <class World>
void add_hub_solve(const Assembly<World>& g);
/// Sums what the subsystems of a rotor on a support add to its hub.
template <class World>
void add_rotor_sum(const Assembly<World>& g, int r);
/// Adds the node of (P 9) where it only yields the reaction: once for all steps that are complete.
template <class World>
void add_prescribed_hub_solve(const Assembly<World>& g);
/// Adds the node of the augmented formulation that does all from the inverses to the hub, (P 4) to
/// (P 6).
template <class World>
void add_augmented_solve(const Assembly<World>& g);
/// Adds the node of the wrenches in the joints of subsystem `i`, (P 8).
template <class World>
void add_multipliers(const Assembly<World>& g, int i);
/// Adds the node of the accelerations of body `j` of subsystem `i`, (P 7), which the integrator
/// takes.
template <class World>
void add_recovery(const Assembly<World>& g, int i, int j);

}  // namespace spoke
