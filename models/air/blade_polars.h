#pragma once

// Coefficients at the stations of a blade.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "models/air.h"
#include "models/air/section_polar.h"

namespace spoke::air {

/// A place between two stations of a blade's aerodynamics, or at one of its ends.
struct StationPlace {
  std::size_t inner, outer;
  double share;  ///< of the outer one

  /// stations: two or more, ascending; at [m].
  StationPlace(const std::vector<double>& stations, double at);
  /// Returns what a column is there; 0 if it is empty.
  double value(const std::vector<double>& column) const {
    return column.empty() ? 0.0 : column[inner] + share * (column[outer] - column[inner]);
  }
};

/// Makes the coefficients at places of a blade [m]. Throws InputError for an aerofoil that `air`
/// lacks, or that is none.
std::vector<std::shared_ptr<const SectionPolar>> make_polars(
    const spatial::BladeAerodynamics& blade, const spatial::Air& air,
    std::span<const double> places);

}  // namespace spoke::air
