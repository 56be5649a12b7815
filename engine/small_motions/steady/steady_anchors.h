#pragma once

// Anchors of loops, and loops on what stands, in steady rotation.

#include <string>

#include "engine/small_motions/steady/steady_model.h"
#include "models/system/system.h"

namespace spoke::steady {

/// Holds the anchors where they come to rest, or at Instant::start where they are at t = 0. If the
/// hub `turns`, of an anchor that turns with it what is along the hub's axis counts: the rest is
/// periodic in the hub's frame, with that mean. Throws InputError if an anchor moves for ever, if
/// rigid rows of a loop turn against the hub, or if a loop closes on the mount of a hub that is
/// free.
template <class World>
void hold_anchors(System<World>& system, bool turns, Instant instant);

/// Returns the name of a loop of a subsystem with springs that the mount, or an anchor beside the
/// hub, holds: their forces turn against the hub. Empty: there is none.
template <class World>
std::string find_standing_springs(const System<World>& system, std::size_t subsystem);

}  // namespace spoke::steady
