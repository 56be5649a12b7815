#pragma once

// Dimensionless thrust, torque and power of rotors.

#include "spoke/export.h"

namespace spoke::air {

/// Thrust, torque and power of a rotor, and what it turns in.
struct RotorLoads {
  double thrust;   ///< along the axis [N]
  double torque;   ///< in the direction of the turn [N m]
  double speed;    ///< in the direction of the turn [rad/s]
  double radius;   ///< [m]
  double density;  ///< of the air [kg/m^3]
};

/// C_T, C_Q and C_P.
struct RotorCoefficients {
  double thrust, torque, power;
};

/// Returns the coefficients by the wind V, as of turbines: over rho A V^2 / 2, rho A R V^2 / 2 and
/// rho A V^3 / 2. wind: along the axis [m/s]. All are 0 without wind.
SPOKE_EXPORT RotorCoefficients calc_wind_coefficients(const RotorLoads& rotor, double wind);

/// Returns the coefficients by the speed of the tip, as of helicopters: over rho A (Omega R)^2,
/// rho A R (Omega R)^2 and rho A (Omega R)^3; torque and power are those that the rotor takes. All
/// are 0 at standstill.
SPOKE_EXPORT RotorCoefficients calc_tip_coefficients(const RotorLoads& rotor);

}  // namespace spoke::air
