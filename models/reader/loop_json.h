#pragma once

// Writes closed loops and anchors as JSON, in the shape of their tables.

#include <vector>

#include "models/reader/loop_faults.h"
#include "models/support/json.h"

namespace spoke {

/// Adds the loops of a blade or a subsystem to its table; nothing if there are none.
void add_loops(const std::vector<Loop>& loops, const LoopSurroundings& around, Json& json);
/// Returns the table of an anchor, but for the name of its rotor.
Json to_json(const Anchor& anchor, bool in_plane);

}  // namespace spoke
