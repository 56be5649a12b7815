#pragma once

// Writes a scenario (TOML) of what was found in files of other programs.

#include <string>

#include "program/foreign/beam_table.h"
#include "program/foreign/scenario_places.h"

namespace spoke::foreign {

/// Returns the text of a scenario in space, with comments on where each value came from and on what
/// was left out. Without `places` it stands alone: polars are in the text, there is neither a file
/// of wind nor a library.
std::string write_scenario(const FoundModel& model, const ScenarioPlaces* places = nullptr);

}  // namespace spoke::foreign
