#pragma once

// How large a section of a beam in space is drawn.

#include "models/space/beam.h"
#include "models/spatial_model.h"

namespace spoke::scene {

/// An ellipse in a section's axes.
struct SectionSize {
  double half_y = 0.0, half_z = 0.0;      ///< semi-axes [m]
  double center_y = 0.0, center_z = 0.0;  ///< from the beam's axis [m]
};

/// By chord and thickness about the axis where they are given; what is not, as of a full ellipse
/// with the section's inertias, about its mass centre. `made`: of `beam`; x: station [m].
SectionSize find_section_size(const spatial::Beam& beam, const space::Beam& made, double x);

}  // namespace spoke::scene
