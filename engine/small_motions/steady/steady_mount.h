#pragma once

// The steady part of a mount that moves the hub's axle.

#include "engine/small_motions/steady/steady_model.h"
#include "models/space/hub.h"

namespace spoke::steady {

/// Takes the mount away and turns the hub's axle to the direction in which the mount holds it. Only
/// that direction counts: a constant velocity of the whole model deforms nothing. A table counts
/// with its end, where it has come to rest; at Instant::start the mount is at rest in its place at
/// t = 0, and its later motion sets in from there. Throws InputError at Instant::end if the mount
/// turns or oscillates for ever.
void hold_mount(space::Hub& hub, Instant instant);

}  // namespace spoke::steady
