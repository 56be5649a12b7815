#pragma once

// Where the files of an imported scenario are.

#include <string>

namespace spoke::foreign {

/// Places of the files of a scenario.
struct ScenarioPlaces {
  std::string folder;    ///< of the scenario; empty: that in which the program runs
  std::string airfoils;  ///< folder of the aerofoils' tables, relative to that of the scenario
  std::string wind;      ///< table of the wind, likewise
};

}  // namespace spoke::foreign
