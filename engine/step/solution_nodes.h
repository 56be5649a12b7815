#pragma once

// The nodes between the terms of the bodies and the end of a pass: what the formulation solves.

#include "engine/step/assembly.h"

namespace spoke {

/// Condenses body `j` of blade `i` to its handles, or inverts its mass matrix, (P 11).
template <class World>
void add_inverse(const Assembly<World>& g, int i, int j);
/// Effective mass and force of blade `i`, (P 10).
template <class World>
void add_effective(const Assembly<World>& g, int i);
/// (P 9) where the hub has a free coordinate: once in each pass.
template <class World>
void add_hub_solve(const Assembly<World>& g);
/// (P 9) where it only yields the reaction: once for all steps that are complete.
template <class World>
void add_prescribed_hub_solve(const Assembly<World>& g);
/// In the augmented formulation all from the inverses to the hub, (P 4) to (P 6).
template <class World>
void add_augmented_solve(const Assembly<World>& g);
/// Wrenches in the joints of blade `i`, (P 8).
template <class World>
void add_multipliers(const Assembly<World>& g, int i);
/// Accelerations of body `j` of blade `i`, (P 7), which the integrator takes.
template <class World>
void add_recovery(const Assembly<World>& g, int i, int j);

}  // namespace spoke
