#pragma once

// Writes a scenario (TOML) of what was found in files of other programs.

#include <string>

#include "program/foreign/beam_table.h"

namespace spoke::foreign {

/// Where the files of a scenario are.
struct ScenarioPlaces {
  std::string folder;    ///< of the scenario; empty: that in which the program runs
  std::string airfoils;  ///< folder of the aerofoils' tables, relative to that of the scenario
  std::string wind;      ///< table of the wind, likewise
};

/// Returns the text of a scenario in space, with comments on where each value came from and on what
/// was left out. Without `places` it stands alone: polars are in the text, there is neither a file
/// of wind nor a library.
std::string write_scenario(const FoundModel& model, const ScenarioPlaces* places = nullptr);

}  // namespace spoke::foreign
