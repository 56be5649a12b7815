#pragma once

// The paper's rotor, built into the program.

#include "models/scenario.h"

namespace spoke {

/// The scenario of models/paper_rotor.toml as it was when the program was built: it can be had
/// without the file. Throws InputError for a bad override.
Scenario paper_rotor(const Overrides& overrides = {});

}  // namespace spoke
