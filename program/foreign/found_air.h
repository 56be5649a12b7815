#pragma once

// What files of other programs say of the air around a rotor and of the aerodynamics of its blades,
// in Spoke's terms.

#include <Eigen/Core>
#include <optional>
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

/// Wind before the rotor. Either a table or a file of TurbSim gives the speed, or `velocity`.
struct FoundWind {
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};  ///< [m/s]; with a table or a file its direction
  std::string velocity_from;
  bool has_profile = false;                             ///< whether the reference height is used
  double vertical_shear = 0.0, horizontal_shear = 0.0;  ///< [1/m]
  std::string table;       ///< text of a table of the scenario's; empty: none
  std::string file, from;  ///< of TurbSim, as the program that imports finds it; empty: none
};

/// A tower in the air, and what it does to the wind of the blades.
struct FoundTowerAir {
  std::vector<double> station, diameter, coefficient;  ///< from the foot on [m, m, -]
  std::string from;
  FoundChoice potential{"none"}, shadow{"none"};
};

/// Air and aerodynamics. What is left out has the scenario's default.
struct FoundAir {
  spatial::BladeAerodynamics blade;
  std::vector<std::string> station_from;  ///< a text for each station
  std::vector<std::string> remarks;       ///< how its numbers were made, a sentence each
  std::vector<FoundAirfoil> airfoils;
  Value density, viscosity;       ///< [kg/m^3, m^2/s]; 0: not in the files
  Value shear, reference_height;  ///< exponent of the power law, [m]; 0: not in the files
  std::optional<FoundWind> wind;  ///< none: the air is at rest
  std::optional<FoundTowerAir> tower;
  FoundChoice induction{"momentum"}, inflow{"dynamic"}, stall{"dynamic"};
};

}  // namespace spoke::foreign
