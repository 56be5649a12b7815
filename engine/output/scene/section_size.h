#pragma once

// The size in which a section of a beam in space is drawn.

#include "models/space/beam.h"
#include "models/spatial_model.h"

namespace spoke::scene {

/// An ellipse in a section's axes.
struct SectionSize {
  double half_y = 0.0, half_z = 0.0;      ///< semi-axes [m]
  double center_y = 0.0, center_z = 0.0;  ///< from the beam's axis [m]
};

/// Returns the size by chord and thickness about the axis where they are given; a dimension that is
/// not given is that of a full ellipse with the inertias of the section, about its mass centre.
/// `made`: made of `beam`; x: station [m].
SectionSize find_section_size(const spatial::Beam& beam, const space::Beam& made, double x);

}  // namespace spoke::scene
