#pragma once

// Reads what carries the axle of the hub.

#include <string>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the table [support] of a scenario's root.
TomlSection support_section(const TomlSection& root);

/// Reads what a support stands on, from [support].
Support read_base(const TomlSection& section);

/// Reads the tree of the model's support, which becomes its last subsystem, and the axle of the
/// first rotor from the table `first`. Meshes are relative to `folder`.
void read_support_tree(const TomlSection& section, const TomlSection& first,
                       const std::string& folder, Model& model);

/// Reads the name of the subsystem whose body carries the axle of a rotor, from the table that has
/// it; empty: the support.
std::string read_axle_carrier(const TomlSection& owner);

/// Reads where the axle of a rotor stands on a tree, from the table that has it. What the support
/// stands on, `from`, may carry it, by its name.
Axle read_axle(const TomlSection& owner, const Subsystem& tree, SupportBase from);

/// Reads [hub.suspension].
Suspension read_suspension(const TomlSection& section);

/// Returns the keys of [hub.suspension].
TomlSection::Keys suspension_keys();

}  // namespace spoke::spatial
