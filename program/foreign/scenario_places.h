#pragma once

// Where a scenario and the files that it names are.

#include <string>

namespace spoke::foreign {

/// Where the files of a scenario are.
struct ScenarioPlaces {
  std::string folder;    ///< of the scenario; empty: that in which the program runs
  std::string airfoils;  ///< folder of the aerofoils' tables, relative to that of the scenario
  std::string wind;      ///< table of the wind, likewise
};

}  // namespace spoke::foreign
