#pragma once

// Reads couplings of joints, and writes them as JSON.

#include <vector>

#include "models/coupling.h"
#include "models/reader/toml_section.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Reads the tables "coupling" of a blade's or a subsystem's table. Throws InputError.
std::vector<Coupling> read_couplings(const TomlSection& parent);

void add_couplings(const std::vector<Coupling>& couplings, Json& json);

}  // namespace spoke::spatial
