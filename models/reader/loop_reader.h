#pragma once

// Reads closed loops and anchors, in the plane and in space.

#include <string>
#include <vector>

#include "models/loop.h"
#include "models/reader/loop_faults.h"
#include "models/reader/toml_section.h"

namespace spoke {

/// Reads the tables "loop" of a blade's or a subsystem's table. Throws InputError, also about what
/// find_fault() finds.
std::vector<Loop> read_loops(const TomlSection& parent, const LoopSurroundings& around);

/// Reads [[anchor]] from a scenario's root. `mount_fault`: find_mount_fault() of the model. Throws
/// InputError, also about what find_fault() finds.
std::vector<Anchor> read_anchors(const TomlSection& root, const std::string& mount_fault,
                                 bool in_plane);

}  // namespace spoke
