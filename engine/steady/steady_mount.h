#pragma once

// What of a mount that moves the hub's axle is steady.

#include "engine/steady/steady_model.h"
#include "models/space/hub.h"

namespace spoke::steady {

/// Takes the mount away and turns the hub's axle to where it holds it. Only that direction counts:
/// a constant velocity of all deforms nothing. A table counts with its end, where it has come to
/// rest; at Instant::start the mount is at rest where it is at t = 0, and what it does from there
/// on sets in then. Throws InputError, of Instant::end, if the mount turns or oscillates for ever.
void hold_mount(space::Hub& hub, Instant instant);

}  // namespace spoke::steady
