#pragma once

// Writes a scenario (TOML) of what was found in files of other programs.

#include <string>

#include "program/foreign/beam_table.h"

namespace spoke::foreign {

/// Returns the text of a scenario in space, with comments on where each value came from and on what
/// was left out.
std::string write_scenario(const FoundModel& model);

}  // namespace spoke::foreign
