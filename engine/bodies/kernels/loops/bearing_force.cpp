// Interpolates the matrices, and splits what they give an implicit step.

#include "engine/bodies/kernels/loops/bearing_force.h"

#include <algorithm>
#include <cmath>

namespace spoke {

double calc_bearing_speed(const BearingModel& bearing, const PlaceMotion& from,
                          const PlaceMotion& to) noexcept {
  const space::Angular turns = angular(from.twist) - angular(to.twist);
  return space::Position(to.R * bearing.axis).dot(turns);
}

BearingForce calc_bearing_force(const BearingModel& bearing, const Eigen::Vector2d& opening,
                                const Eigen::Vector2d& rate, double speed, double position_gain,
                                double velocity_gain) noexcept {
  const BearingCoefficients at = bearing.at(speed);
  BearingForce found;
  found.force = -at.stiffness * opening - at.damping * rate;
  const Eigen::Vector2d lost = -found.force - bearing.storing() * opening;
  found.loss = lost.cwiseProduct(rate);
  found.compliance.setZero();
  if (position_gain > 0.0)
    found.compliance =
        calc_definite_inverse(position_gain * at.stiffness + velocity_gain * at.damping);
  return found;
}

// With l the eigenvalues, m their mean and d half their difference, 1/G = (mean of 1/l) 1 + (half
// the difference of 1/l) (G - m)/d.
Eigen::Matrix2d calc_definite_inverse(const Eigen::Matrix2d& G) noexcept {
  constexpr double kLeast = 1e-6;
  constexpr double kNone = 1e-12;  // of matrices that are zero, which give no force [kg]
  const double mean = 0.5 * (G(0, 0) + G(1, 1)), off = 0.5 * (G(0, 1) + G(1, 0));
  const double half = 0.5 * (G(0, 0) - G(1, 1)), radius = std::hypot(half, off);
  const double least = std::max(kLeast * G.norm(), kNone);
  const double high = 1.0 / std::max(mean + radius, least);
  const double low = 1.0 / std::max(mean - radius, least);
  const double share = radius > 0.0 ? 0.5 * (high - low) / radius : 0.0;
  Eigen::Matrix2d inverse;
  inverse << 0.5 * (high + low) + share * half, share * off, share * off,
      0.5 * (high + low) - share * half;
  return inverse;
}

}  // namespace spoke
