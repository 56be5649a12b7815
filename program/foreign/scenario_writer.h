#pragma once

// Writes a scenario (TOML) of what was found in files of other programs.

#include <string>

#include "program/foreign/beam_table.h"

namespace spoke::foreign {

/// Returns the text of a scenario in space, with comments on where each value came from and on what
/// was left out. Aerofoils are named as tables in `airfoil_folder`, relative to that of the
/// scenario; if it is empty, their polars are in the text.
std::string write_scenario(const FoundModel& model, const std::string& airfoil_folder = {});

}  // namespace spoke::foreign
