#pragma once

// Rotations and twist algebra of the plane, and `Plane`, the argument of the templates that are
// written for a `World`: chains, hub, dense formulations, step graph, integrators. Other code of
// the plane is written for it alone, see docs/architecture.md.

#include <cmath>

#include "models/vectors.h"
#include "models/world.h"

namespace spoke {

/// Returns the quarter turn B of (P 3): cross(w, r) = w B r.
inline Position quarter_turn(const Position& r) { return {-r.y(), r.x()}; }

/// Returns the velocity of a point r away that an angular velocity w makes.
inline Position cross(double w, const Position& r) { return w * quarter_turn(r); }
/// Returns the acceleration of a point r away that an angular velocity w makes.
inline Position centripetal(double w, const Position& r) { return -w * w * r; }
/// Returns the translational part of a twist.
inline auto linear(Twist& v) { return v.head<kPosition>(); }
inline auto linear(const Twist& v) { return v.head<kPosition>(); }
/// Returns the angular part of a twist.
inline double& angular(Twist& v) { return v[kRotation]; }
inline double angular(const Twist& v) { return v[kRotation]; }

/// Returns the twist of a point s away from a frame of twist v, which moves against the frame at
/// rate `s_rate` and turns at `turning`.
inline Twist carry(const Twist& v, const Position& s, const Position& s_rate, double turning) {
  const double w = v[kRotation];
  return {v[0] - w * s.y() + s_rate.x(), v[1] + w * s.x() + s_rate.y(), w + turning};
}
inline Twist make_wrench(const Position& force, double moment) {
  return {force.x(), force.y(), moment};
}
/// Returns the rotary part of a mass matrix.
inline double& rotary(TwistMatrix& m) { return m(kRotation, kRotation); }

/// T^T f: refers a wrench at a bracket to the point from which p leads there.
inline Twist translate(const Position& p, const Twist& f) {
  return {f[0], f[1], f[2] + p.x() * f[1] - p.y() * f[0]};
}

namespace plane {

using spoke::translate;

/// Rotation R_AB in the plane: takes components resolved in frame B to frame A.
struct Rotation {
  double cosine = 1.0;
  double sine = 0.0;

  static Rotation from_angle(double angle) {
#ifdef __GLIBC__  // one call for both, which Clang does not make of two
    Rotation R;
    sincos(angle, &R.sine, &R.cosine);
    return R;
#else
    return {std::cos(angle), std::sin(angle)};
#endif
  }

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
  TwistMatrix matrix() const {
    TwistMatrix r;
    r << cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0;
    return r;
  }
};

/// A symmetric twist matrix (mass, compliance) by its six values: x, y and r (rotation). Kept as
/// single numbers, it stays in registers where a matrix would go through memory.
struct SymmetricTwistMatrix {
  double xx = 0.0;
  double yx = 0.0, yy = 0.0;
  double rx = 0.0, ry = 0.0, rr = 0.0;

  TwistMatrix matrix() const {
    TwistMatrix m;
    m << xx, yx, rx, yx, yy, ry, rx, ry, rr;
    return m;
  }
  SymmetricTwistMatrix operator+(const SymmetricTwistMatrix& b) const {
    return {xx + b.xx, yx + b.yx, yy + b.yy, rx + b.rx, ry + b.ry, rr + b.rr};
  }
  Twist operator*(const Twist& v) const {
    return {xx * v[0] + yx * v[1] + rx * v[2], yx * v[0] + yy * v[1] + ry * v[2],
            rx * v[0] + ry * v[1] + rr * v[2]};
  }
};

/// R A R^T: converts a matrix resolved in frame B to frame A.
inline SymmetricTwistMatrix rotate(const Rotation& R, const SymmetricTwistMatrix& a) {
  const double c = R.cosine, s = R.sine;
  const double cc = c * c, ss = s * s, cs = c * s;
  const double shear = 2.0 * cs * a.yx;
  return {cc * a.xx - shear + ss * a.yy, cs * (a.xx - a.yy) + (cc - ss) * a.yx,
          ss * a.xx + shear + cc * a.yy, c * a.rx - s * a.ry,
          s * a.rx + c * a.ry,           a.rr};
}

/// T^T A T with T = [I, B p; 0, 1]: refers a mass at a bracket to the point from which p leads
/// there.
inline SymmetricTwistMatrix translate(const Position& p, const SymmetricTwistMatrix& a) {
  const double x = p.x(), y = p.y();
  const double rx = a.rx - y * a.xx + x * a.yx;
  const double ry = a.ry - y * a.yx + x * a.yy;
  return {a.xx, a.yx, a.yy, rx, ry, a.rr + x * (a.ry + ry) - y * (a.rx + rx)};
}

/// Returns the inverse of a positive definite matrix; not finite if it is singular.
inline SymmetricTwistMatrix invert(const SymmetricTwistMatrix& a) {
  const double xx = a.yy * a.rr - a.ry * a.ry;
  const double yx = a.rx * a.ry - a.yx * a.rr;
  const double rx = a.yx * a.ry - a.yy * a.rx;
  const double scale = 1.0 / (a.xx * xx + a.yx * yx + a.rx * rx);
  return {scale * xx,
          scale * yx,
          scale * (a.xx * a.rr - a.rx * a.rx),
          scale * rx,
          scale * (a.yx * a.rx - a.xx * a.ry),
          scale * (a.xx * a.yy - a.yx * a.yx)};
}

/// C - A B A^T: C after the elimination of a joint of compliance B^-1.
inline SymmetricTwistMatrix eliminate(const SymmetricTwistMatrix& c, const TwistMatrix& a,
                                      const SymmetricTwistMatrix& b) {
  const double a00 = a(0, 0), a01 = a(0, 1), a02 = a(0, 2);
  const double a10 = a(1, 0), a11 = a(1, 1), a12 = a(1, 2);
  const double a20 = a(2, 0), a21 = a(2, 1), a22 = a(2, 2);
  const double b00 = a00 * b.xx + a01 * b.yx + a02 * b.rx;
  const double b01 = a00 * b.yx + a01 * b.yy + a02 * b.ry;
  const double b02 = a00 * b.rx + a01 * b.ry + a02 * b.rr;
  const double b10 = a10 * b.xx + a11 * b.yx + a12 * b.rx;
  const double b11 = a10 * b.yx + a11 * b.yy + a12 * b.ry;
  const double b12 = a10 * b.rx + a11 * b.ry + a12 * b.rr;
  const double b20 = a20 * b.xx + a21 * b.yx + a22 * b.rx;
  const double b21 = a20 * b.yx + a21 * b.yy + a22 * b.ry;
  const double b22 = a20 * b.rx + a21 * b.ry + a22 * b.rr;
  return {c.xx - (b00 * a00 + b01 * a01 + b02 * a02), c.yx - (b10 * a00 + b11 * a01 + b12 * a02),
          c.yy - (b10 * a10 + b11 * a11 + b12 * a12), c.rx - (b20 * a00 + b21 * a01 + b22 * a02),
          c.ry - (b20 * a10 + b21 * a11 + b22 * a12), c.rr - (b20 * a20 + b21 * a21 + b22 * a22)};
}

/// Position and orientation of frame B in frame A.
struct Pose {
  Position p = Position::Zero();  ///< origin of B, resolved in A [m]
  Rotation R;                     ///< R_AB
};

/// Joints of the plane are rigid, and connect a handle to the child's inboard one.
struct Joint {};

struct FlexibleBody;
struct Stiffening;

}  // namespace plane

struct Hub;
struct HubLoad;

/// The plane, as a `World`: its sizes and types.
struct Plane {
  static constexpr int kPosition = spoke::kPosition;
  static constexpr int kTwist = spoke::kTwist;
  /// Components of a twist about z: the axis of an axle.
  static constexpr int kAxial = kRotation;
  using Position = spoke::Position;
  using Angular = double;  ///< angular velocity, moment
  using Twist = spoke::Twist;
  using TwistMatrix = spoke::TwistMatrix;
  using SymmetricTwistMatrix = plane::SymmetricTwistMatrix;
  using Rotation = plane::Rotation;
  using Pose = plane::Pose;

  using Hub = spoke::Hub;
  using HubLoad = spoke::HubLoad;
  using Body = plane::FlexibleBody;
  using Joint = plane::Joint;
  using Stiffening = plane::Stiffening;
  /// Joints of the plane are rigid.
  static constexpr int kMostJointCoordinates = 0;
};

}  // namespace spoke
