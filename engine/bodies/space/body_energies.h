#pragma once

// Energies and first moment of a spatial body, for the sensors.

#include "models/space/space.h"

namespace spoke::space {

/// Energies and first moment of a body at a state, for the sensors.
struct BodyEnergies {
  double kinetic = 0.0;           ///< stiffening term included [J]
  double strain = 0.0;            ///< elastic energy 1/2 q^T K q [J]
  double tension = 0.0;           ///< energy of gravity's tension, g . gamma [J]
  Position S = Position::Zero();  ///< first moment [kg m]
};

}  // namespace spoke::space
