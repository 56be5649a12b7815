#pragma once

// The scenario of the paper's rotor, built into the program.

#include "models/scenario.h"

namespace spoke {

/// Returns the scenario of models/paper_rotor.toml as it was when the program was built; the file
/// is not read. Throws InputError for a bad override.
Scenario paper_rotor(const Overrides& overrides = {});

}  // namespace spoke
