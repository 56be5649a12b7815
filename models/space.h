#pragma once

// The part of Spoke that knows it lives in a plane: sizes, rotations, and how a twist turns.
// Everything built on these names (joints, condensation, hub, formulations, integrators) is
// written for a general number of twist components; a spatial engine replaces this file and the
// finite element (beam_elements), nothing else.

#include <Eigen/Core>
#include <cmath>

namespace spoke {

/// Components of a position: x, y.
inline constexpr int kPosition = 2;
/// Components of a twist: velocity (x, y) and angular velocity. Also the coordinates of a node.
inline constexpr int kTwist = 3;
/// Index of the (last) rotational component of a twist.
inline constexpr int kRotation = 2;

// Unaligned, so that structures of these hold nothing but doubles side by side (no padding): the
// step graph's declaration check compares their memory.
using Position = Eigen::Matrix<double, kPosition, 1, Eigen::DontAlign>;
using Twist = Eigen::Matrix<double, kTwist, 1>;
using TwistMatrix = Eigen::Matrix<double, kTwist, kTwist>;

/// Rotation R_AB in the plane: takes components resolved in frame B to frame A.
struct Rotation {
  double cosine = 1.0;
  double sine = 0.0;

  static Rotation from_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

  Rotation inverse() const { return {cosine, -sine}; }

  Position operator*(const Position& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }
  Rotation operator*(const Rotation& other) const {
    return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
  }
  /// A twist or wrench keeps its rotational component in the plane.
  Twist operator*(const Twist& v) const {
    return {cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], v[2]};
  }
  /// R A R^T: a symmetric twist matrix (mass, compliance) resolved in frame B, to frame A.
  TwistMatrix turn(const TwistMatrix& a) const {
    const double c = cosine, s = sine;
    const double cc = c * c, ss = s * s, cs = c * s;
    const double shear = 2.0 * cs * a(1, 0);
    TwistMatrix r;
    r(0, 0) = cc * a(0, 0) - shear + ss * a(1, 1);
    r(1, 1) = ss * a(0, 0) + shear + cc * a(1, 1);
    r(1, 0) = cs * (a(0, 0) - a(1, 1)) + (cc - ss) * a(1, 0);
    r(2, 0) = c * a(2, 0) - s * a(2, 1);
    r(2, 1) = s * a(2, 0) + c * a(2, 1);
    r(2, 2) = a(2, 2);
    r(0, 1) = r(1, 0);
    r(0, 2) = r(2, 0);
    r(1, 2) = r(2, 1);
    return r;
  }
  TwistMatrix matrix() const {
    TwistMatrix r;
    r << cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0;
    return r;
  }
};

/// The quarter turn B of (P 3): cross(w, r) = w B r.
inline Position quarter_turn(const Position& r) { return {-r.y(), r.x()}; }

/// Inverse of a symmetric positive definite twist matrix; its lower triangle is read. Not finite if
/// the matrix is singular.
inline TwistMatrix invert_symmetric(const TwistMatrix& a) {
  const double c00 = a(1, 1) * a(2, 2) - a(2, 1) * a(2, 1);
  const double c10 = a(2, 0) * a(2, 1) - a(1, 0) * a(2, 2);
  const double c20 = a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0);
  const double c11 = a(0, 0) * a(2, 2) - a(2, 0) * a(2, 0);
  const double c21 = a(1, 0) * a(2, 0) - a(0, 0) * a(2, 1);
  const double c22 = a(0, 0) * a(1, 1) - a(1, 0) * a(1, 0);
  const double scale = 1.0 / (a(0, 0) * c00 + a(1, 0) * c10 + a(2, 0) * c20);
  TwistMatrix inverse;
  inverse << c00, c10, c20, c10, c11, c21, c20, c21, c22;
  return inverse * scale;
}

/// Position and orientation of frame B in frame A.
struct Pose {
  Position p = Position::Zero();  ///< origin of B, resolved in A [m]
  Rotation R;                     ///< R_AB
};

}  // namespace spoke
