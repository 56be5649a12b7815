#pragma once

// Reads closed loops and anchors, in the plane and in space.

#include <functional>
#include <string>
#include <vector>

#include "models/loop.h"
#include "models/reader/loop_faults.h"
#include "models/reader/toml_section.h"

namespace spoke {

/// Reads the tables "loop" of a blade's or a subsystem's table. Throws InputError, also about what
/// find_fault() finds.
std::vector<Loop> read_loops(const TomlSection& parent, const LoopSurroundings& around);

/// Reads the number of the rotor that a table names.
using RotorReader = std::function<int(const TomlSection&)>;

/// Reads the keys "blade" and "subsystem" of a table that is about another one, of which there is
/// one at most; what they name is looked at later.
void read_elsewhere(const TomlSection& table, int& blade, std::string& subsystem);

/// Reads [[anchor]] from a scenario's root. `mount_fault`: find_mount_fault() of the model;
/// `read_rotor`: of a model in space, empty in the plane. Throws InputError, also about what
/// find_fault() finds.
std::vector<Anchor> read_anchors(const TomlSection& root, const std::string& mount_fault,
                                 const RotorReader& read_rotor);

}  // namespace spoke
