#pragma once

// Reads blades and subsystems.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Reads [blade] and [[blades]] of a rotor from a scenario's root, or from its table; none if there
/// are none. The model has its hubs and its anchors, on which loops may close.
std::vector<Blade> read_blades(const TomlSection& root, int rotor, const Model& model);

/// Reads the number of the rotor that a table names under "rotor"; the first if it names none.
int read_rotor_of(const TomlSection& section, const Model& model);

/// Reads a name, which must be one.
std::string read_name(const TomlSection& section, std::string_view key);

/// Reads the bodies, joints and loops of a tree, which has its name, from its table. A joint on the
/// base may leave out its parent if the model's support stands there. `before`: subsystems that are
/// read, which lend their meshes.
void read_tree(const TomlSection& section, const Model& model, const std::string& folder,
               const std::vector<Subsystem>& before, Subsystem& tree);

/// Reads a place on a beam of a tree, or none: "station", or "node" counted from the root.
std::optional<double> read_station(const TomlSection& section, const Subsystem& tree,
                                   const std::string& body);

/// Reads [[subsystem]] from a scenario's root. The model has its hub and its anchors; meshes are
/// relative to `folder`. One with a count N makes N subsystems, named NAME1 to NAMEN.
std::vector<Subsystem> read_subsystems(const TomlSection& root, const Model& model,
                                       const std::string& folder);

/// Returns the names of the subsystems that a name stands for: of those that a count has made, or
/// the name itself.
std::vector<std::string> find_copies(const TomlSection& root, const std::string& name);

}  // namespace spoke::spatial
