#pragma once

// Aerofoils in the form C81 of helicopter codes: lift, drag and moment over angle of attack and
// Mach number, each table on a grid of its own.

#include <string>
#include <string_view>
#include <vector>

#include "models/air.h"

namespace spoke::air {

/// Whether a text is such a table: the first line ends in six counts of two columns each.
bool is_c81_airfoil(std::string_view text);

/// Reads the tables and returns a polar for each Mach number of any of them, on the angles of all:
/// linear between their points, as codes that read C81 take them, so exact. Throws InputError
/// "file:line: ..." for whatever is not as it must be.
std::vector<spatial::Polar> read_c81_airfoil(std::string_view text, const std::string& file);

}  // namespace spoke::air
