#pragma once

// What an aerofoil must be, wherever it comes from.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "models/air.h"

namespace spoke::air {

/// Drag that is tolerated, with a warning: polars that were extended to all angles of attack may
/// dip below zero where there is next to none.
inline constexpr double kLeastDrag = -0.01;

/// What is wrong with a polar, in the words of a table of text and in those of the member.
struct PolarFault {
  int row = -1;                   ///< from 0; -1: the column as a whole
  std::string column;             ///< "angle", "lift", "drag" or "moment"
  std::string what;               ///< "drag is -3, expected 0 to 100"; angles in degrees
  std::string is;                 ///< "is -3, expected 0 to 100"; angles in rad
  bool only_ends_differ = false;  ///< all else is well
};

/// Finds what is wrong with a polar: angles of attack that do not ascend from -pi to pi, fewer than
/// three, columns of another length, numbers that are not finite or far from any aerofoil's, drag
/// below kLeastDrag, ends that differ. None if all is well.
std::optional<PolarFault> find_polar_fault(const spatial::Polar& polar);

/// Returns what is wrong with the Mach number of one of an aerofoil's polars; empty: nothing is.
std::string find_mach_fault(const std::vector<spatial::Polar>& polars, std::size_t k);

/// Throws InputError "aerofoil "NAME": ..." unless the aerofoil has polars, all are well, and their
/// Reynolds or Mach numbers ascend.
void check_airfoil(const spatial::Airfoil& airfoil);

}  // namespace spoke::air
