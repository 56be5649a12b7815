#pragma once

// How far a solid may deform: the range of linear elasticity, and limits beyond which its linear
// model means nothing.

#include "models/space/solid.h"

namespace spoke::space {

/// A strain counts as a rotation this many times as large.
inline constexpr double kStrainWeight = 10.0;
/// Returns the largest deformation of a solid: the displacement of an interface or of its tip by
/// its extent, the rotation of an interface [rad], or kStrainWeight times the strain of a node that
/// its von Mises stress makes.
double find_largest_deflection(const Solid& body, const double* q) noexcept;

/// Returns the sum of the squares of all coordinates up to which no displacement of a place is
/// above `range` [m], and no rotation and strain above its share of the extent.
double calc_surely_linear(const Solid& body, double range);

/// Finds the first coordinate that is not finite, or else the one farthest beyond its limit.
struct ModeViolation {
  int coordinate = -1;  ///< -1: none has left its limits
  double value = 0.0;
  double limit = 0.0;
};
ModeViolation find_limit_violation(const Solid& body, const double* q) noexcept;

}  // namespace spoke::space
