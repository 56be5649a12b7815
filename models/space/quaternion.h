#pragma once

// Unit quaternions as orientations: four numbers (w, x, y, z), w the real one.

#include "models/space/rotation.h"

namespace spoke::space {

/// A quaternion (w, (x, y, z)); of unit length it is the rotation R_AB by the angle t about the
/// axis n: w = cos(t/2), (x, y, z) = sin(t/2) n.
struct Quaternion {
  double w = 1.0;
  Position v = Position::Zero();

  Quaternion operator*(const Quaternion& b) const {
    return {w * b.w - v.dot(b.v), w * b.v + b.w * v + cross(v, b.v)};
  }
  Quaternion operator+(const Quaternion& b) const { return {w + b.w, v + b.v}; }
  Quaternion conjugate() const { return {w, -v}; }
  double squared_norm() const { return w * w + v.squaredNorm(); }
};

inline Quaternion operator*(double factor, const Quaternion& Q) {
  return {factor * Q.w, factor * Q.v};
}

/// Returns the quaternion scaled to unit length.
Quaternion normalize(const Quaternion& Q);

/// Returns the rotation of a unit quaternion.
Rotation make_rotation(const Quaternion& Q);

/// Returns the unit quaternion of a rotation, with w >= 0.
Quaternion make_quaternion(const Rotation& R);

/// Returns the unit quaternion of the rotation vector `theta`.
Quaternion make_quaternion(const Angular& theta);

/// Returns the rotation vector of a quaternion, which need not be of unit length, with an angle 0
/// <= t <= pi. (Q and -Q are one rotation.)
Angular logarithm(const Quaternion& Q);

/// The frame in which the angular velocity of B in A, and a rotation vector that turns B, are
/// resolved: the child B, or the parent A.
enum class TurnFrame { child, parent };

/// Returns Q turned by the rotation vector D: Q exp(D~) in the child's frame, exp(D~) Q in the
/// parent's.
Quaternion turn(const Quaternion& Q, const Angular& D, TurnFrame frame);

/// Q' = 1/2 Q (0, w), w the angular velocity of B in A, resolved in B.
Quaternion calc_rate(const Quaternion& Q, const Angular& w);

/// Q' = 1/2 (0, w) Q, w the angular velocity of B in A, resolved in A.
Quaternion calc_rate(const Angular& w, const Quaternion& Q);

}  // namespace spoke::space
