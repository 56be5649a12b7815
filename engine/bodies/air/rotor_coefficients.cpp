// Coefficients by the wind and by the speed of the tip.

#include "engine/bodies/air/rotor_coefficients.h"

#include <cmath>
#include <numbers>

namespace spoke::air {
namespace {

/// Returns the coefficients by a speed [m/s] and `factor` times rho A.
RotorCoefficients divide(const RotorLoads& rotor, double speed, double factor) {
  const double size = std::abs(speed);
  const double force =
      factor * rotor.density * std::numbers::pi * rotor.radius * rotor.radius * size * size;
  if (!(force > 0.0)) return {0.0, 0.0, 0.0};
  return {rotor.thrust / force, rotor.torque / (force * rotor.radius),
          rotor.torque * rotor.speed / (force * size)};
}

}  // namespace

RotorCoefficients calc_wind_coefficients(const RotorLoads& rotor, double wind) {
  return divide(rotor, wind, 0.5);
}

RotorCoefficients calc_tip_coefficients(const RotorLoads& rotor) {
  const RotorCoefficients driving = divide(rotor, rotor.speed * rotor.radius, 1.0);
  return {driving.thrust, -driving.torque, -driving.power};
}

}  // namespace spoke::air
