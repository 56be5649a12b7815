#pragma once

// Anchors of loops in steady rotation.

#include "engine/small_motions/steady/steady_model.h"
#include "models/system/system.h"

namespace spoke::steady {

/// Holds the anchors where they come to rest, or at Instant::start where they are at t = 0. If the
/// hub `turns`, of an anchor that turns with it what is along the hub's axis counts: the rest is
/// periodic in the hub's frame, with that mean. Throws InputError if an anchor moves for ever, or
/// if a loop closes on what turns against the hub or on the mount of a hub that is free.
template <class World>
void hold_anchors(System<World>& system, bool turns, Instant instant);

}  // namespace spoke::steady
