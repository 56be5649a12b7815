#pragma once

// The table [statistics].

#include <string>

#include "models/reader/toml_section.h"
#include "models/scenario.h"

namespace spoke {

/// Reads [statistics] of a scenario whose model has been read. Throws InputError.
Statistics read_statistics(const TomlSection& root, const Scenario& scenario);

/// Throws InputError where the exponents of a scenario are not as the reader lets them be.
void check_statistics(const Scenario& scenario);

}  // namespace spoke
