#pragma once

// Aerofoil files of AeroDyn 15: lines of a value and its key, and tables of coefficients.

#include <string>
#include <string_view>
#include <vector>

#include "models/air/airfoil_lines.h"

namespace spoke::air {

/// A table of such a file.
struct AerodynTable {
  double reynolds = 0.0;
  int line = 0;  ///< of the Reynolds number
  AirfoilRows rows;
};

/// Returns whether a text has a line of a value and then the key NumTabs.
bool is_aerodyn_airfoil(std::string_view text);

/// Reads the tables. Of tables for several control settings those for 0. Throws InputError.
std::vector<AerodynTable> read_aerodyn_airfoil(std::string_view text, const std::string& file);

}  // namespace spoke::air
