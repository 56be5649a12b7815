#pragma once

// Splits the lift of a polar into that of attached and of separated flow, for dynamic stall.

#include <span>
#include <vector>

namespace spoke::air {

/// Steady lift as f attached + (1 - f) separated at each angle of a polar.
struct Separation {
  double zero_lift = 0.0;         ///< angle of attack [rad]; 0 if there is none
  double slope = 0.0;             ///< of attached lift there [1/rad]; 0: none is attached
  std::vector<double> point;      ///< f: 0: separated at the leading edge; 1: attached
  std::vector<double> attached;   ///< lift
  std::vector<double> separated;  ///< lift
};

/// Makes the split by Kirchhoff's flow past a flat plate (Hansen, Gaunaa & Madsen, Risoe-R-1354,
/// 2004): lift = slope sin(angle - zero lift) ((1 + sqrt f) / 2)^2, and f = 1 where lift is larger.
/// angle: ascending from -pi to pi [rad]; lift: as many. Flow more than 60 degrees from zero lift
/// is separated, and so is all beyond a place where f is 0.
Separation separate(std::span<const double> angle, std::span<const double> lift);

}  // namespace spoke::air
