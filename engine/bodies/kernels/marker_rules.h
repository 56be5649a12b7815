#pragma once

// What a marker must be on a body of either world.

#include <string>

#include "engine/load.h"

namespace spoke {

/// Throws InputError if a marker names an interface; `whose` begins the message.
void require_no_interface(const std::string& whose, const Marker& marker);

/// Throws InputError unless a marker is at a station of a beam.
void require_on_beam(const std::string& whose, const Marker& marker);

}  // namespace spoke
