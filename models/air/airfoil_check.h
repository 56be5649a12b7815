#pragma once

// What an aerofoil must be, wherever it comes from.

#include <optional>
#include <string>

#include "models/air.h"

namespace spoke::air {

/// What is wrong with a polar: row, from 0, or -1, and a clause "alpha is 3, expected ...".
struct PolarFault {
  int row = -1;
  std::string what;
  bool only_ends_differ = false;  ///< all else is well
};

/// Finds what is wrong with a polar: angles of attack that do not ascend from -pi to pi, fewer than
/// three, columns of another length, numbers that are not finite or far from any aerofoil's, drag
/// below zero, ends that differ. None if all is well.
std::optional<PolarFault> find_polar_fault(const spatial::Polar& polar);

/// Throws InputError "aerofoil "NAME": ..." unless the aerofoil has polars, all are well, and their
/// Reynolds numbers ascend.
void check_airfoil(const spatial::Airfoil& airfoil);

}  // namespace spoke::air
