#pragma once

// Uniform blades whose equilibria and modes are known, as scenarios.

#include <string>

#include "models/scenario.h"

namespace spoke::test {

/// A uniform blade of unit length, mass per length and bending stiffness, from the hub's radius on,
/// at constant speed.
struct UnitBlade {
  int bodies = 4;
  int elements = 4;
  double radius = 0.0;
  double axial_stiffness = 1e8;
  double bending_stiffness = 1.0;
  std::string joint = {};  ///< TOML of a joint of the blade in space
  std::string more = {};   ///< TOML of further tables
};

/// Makes the blade in the plane.
Scenario make_planar(const UnitBlade& blade);
/// Makes the blade in space, with equal lag and flap.
Scenario make_spatial(const UnitBlade& blade);

}  // namespace spoke::test
