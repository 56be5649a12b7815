#pragma once

// What files of other programs say of the air around a rotor and of the aerodynamics of its blades,
// in Spoke's terms.

#include <string>
#include <vector>

#include "models/air.h"
#include "program/foreign/value.h"

namespace spoke::foreign {

/// An aerofoil, which goes to a file of its own.
struct FoundAirfoil {
  spatial::Airfoil airfoil;  ///< what reading the table gives
  std::string table;         ///< the text of its file
  std::string from;          ///< "aerofoil 3, polars/du40.dat"
};

/// A model of the air: a word of the scenario, and where it came from.
struct FoundChoice {
  std::string_view word;
  std::string from = "not in the files";
};

/// Air and aerodynamics. What is left out has the scenario's default.
struct FoundAir {
  spatial::BladeAerodynamics blade;
  std::vector<std::string> station_from;  ///< a text for each station
  std::vector<std::string> remarks;       ///< how its numbers were made, a sentence each
  std::vector<FoundAirfoil> airfoils;
  Value density, viscosity;       ///< [kg/m^3, m^2/s]; 0: not in the files
  Value shear, reference_height;  ///< exponent of the power law, [m]; 0: not in the files
  FoundChoice induction{"momentum"}, inflow{"dynamic"}, stall{"dynamic"};
};

}  // namespace spoke::foreign
