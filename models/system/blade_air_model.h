#pragma once

// What air does to a blade, as constants of its subsystem.

#include <memory>
#include <vector>

#include "models/air/section_polar.h"
#include "models/spatial_model.h"

namespace spoke {

/// The aerodynamics of a blade, placed on the bodies of its subsystem.
struct BladeAirModel {
  /// A station on a body.
  struct Place {
    int body = 0;
    double station = 0.0;  ///< on the body [m]
  };

  spatial::BladeAerodynamics aerodynamics;
  std::shared_ptr<const spatial::Air> air;
  int blades = 1;             ///< of the rotor that have aerodynamics: they share its annuli
  double hub_radius = 0.0;    ///< of the undeformed blade's root from the axis [m]
  double tip_radius = 0.0;    ///< of its tip [m]
  std::vector<Place> places;  ///< by station
  /// Coefficients by station; blades that are alike have the same ones.
  std::vector<std::shared_ptr<const air::SectionPolar>> polars;
};

}  // namespace spoke
