#pragma once

// Rotation vectors theta = (axis) (angle) [rad]: the exponential exp(theta~), its tangent map H,
// and the logarithm. With t = |theta|,
//   exp(theta~) = 1 + s theta~ + c theta~^2,    s = sin t / t,   c = (1 - cos t) / t^2
//   H = 1 + c theta~ + d theta~^2,              d = (t - sin t) / t^3
// If R_AB = exp(theta~), the angular velocity of B in A is H theta' resolved in A, and H^T theta'
// resolved in B.

#include "models/space/rotation.h"

namespace spoke::space {

/// Coefficients of a rotation by the angle t, exact to round-off for all angles.
struct RotationCoefficients {
  double s, c, d;  ///< s, c, d of the equations above
  double c_rate;   ///< (s - 2 c) / t^2 = c' / (t t')
  double d_rate;   ///< (c - 3 d) / t^2 = d' / (t t')
};
RotationCoefficients calc_rotation_coefficients(double angle_squared);

/// exp(theta~).
Rotation exponential(const Angular& theta);

/// H(theta).
Matrix3 calc_tangent(const Angular& theta);

/// The orientation R_AB and its rates that follow from a rotation vector [rad] and its rate
/// [rad/s]. The angular acceleration of B in A is H theta'' + convective.
struct RotationVectorMotion {
  Rotation R;          ///< exp(theta~)
  Matrix3 H;           ///< the tangent map
  Angular velocity;    ///< H theta', resolved in A [rad/s]
  Angular convective;  ///< H' theta', resolved in A [rad/s^2]
};
RotationVectorMotion calc_rotation_vector_motion(const Angular& theta, const Angular& rate);

/// Returns the rotation vector of a rotation, of an angle between 0 and pi.
Angular logarithm(const Rotation& R);

}  // namespace spoke::space
