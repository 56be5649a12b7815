#pragma once

// Sizes and vectors of space, and the products of three components that the plane has no need of.

#include <Eigen/Core>

namespace spoke::space {

/// Components of a position: x, y, z.
inline constexpr int kPosition = 3;
/// Components of an angular velocity.
inline constexpr int kAngular = 3;
/// Components of a twist: velocity and angular velocity.
inline constexpr int kTwist = kPosition + kAngular;
/// Index of the first rotational component of a twist.
inline constexpr int kRotation = kPosition;

// All unaligned, so that structures of these hold nothing but doubles side by side (see
// models/vectors.h).
/// Three components of a vector [m, N, ...].
using Position = Eigen::Matrix<double, kPosition, 1, Eigen::DontAlign>;
/// An angular velocity, a moment, a rotation vector [rad/s, N m, rad].
using Angular = Position;
/// A velocity and an angular velocity, or a force and a moment.
using Twist = Eigen::Matrix<double, kTwist, 1, Eigen::DontAlign>;
/// A linear map of twists.
using TwistMatrix = Eigen::Matrix<double, kTwist, kTwist, Eigen::DontAlign>;
/// A linear map of vectors.
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;

inline Twist make_twist(const Position& translation, const Angular& rotation) {
  Twist v;
  v << translation, rotation;
  return v;
}

/// Returns the matrix a~ with a~ b = a x b.
inline Matrix3 skew(const Position& a) {
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

/// a~ m: the cross products of a with every column of m.
inline Matrix3 cross_columns(const Position& a, const Matrix3& m) {
  Matrix3 result;
  result.row(0) = a.y() * m.row(2) - a.z() * m.row(1);
  result.row(1) = a.z() * m.row(0) - a.x() * m.row(2);
  result.row(2) = a.x() * m.row(1) - a.y() * m.row(0);
  return result;
}

}  // namespace spoke::space

namespace spoke {

// Functions of vectors alone are not found by their arguments: they stand beside those of the
// plane, and take what has the size of theirs, an expression too.

/// A column of `size` numbers.
template <class V, int size>
concept ColumnOf = V::RowsAtCompileTime == size&& V::ColsAtCompileTime == 1;

/// w x r.
template <ColumnOf<3> W, ColumnOf<3> R>
space::Position cross(const Eigen::MatrixBase<W>& w, const Eigen::MatrixBase<R>& r) {
  const space::Position a = w, b = r;
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// Returns the translational components of a twist.
inline auto linear(const space::Twist& v) { return v.head<space::kPosition>(); }
inline auto linear(space::Twist& v) { return v.head<space::kPosition>(); }
/// Returns the rotational components of a twist.
inline auto angular(const space::Twist& v) { return v.tail<space::kAngular>(); }
inline auto angular(space::Twist& v) { return v.tail<space::kAngular>(); }

/// w x (w x r): the acceleration of a point r away that an angular velocity w makes.
template <ColumnOf<3> W, ColumnOf<3> R>
space::Position centripetal(const Eigen::MatrixBase<W>& w, const Eigen::MatrixBase<R>& r) {
  return cross(w, cross(w, r));
}

inline space::Twist make_wrench(const space::Position& force, const space::Angular& moment) {
  return space::make_twist(force, moment);
}
/// Returns the rotary part of a mass matrix.
inline auto rotary(space::TwistMatrix& m) { return m.bottomRightCorner<3, 3>(); }

/// T^T f with T = [1, -p~; 0, 1]: refers a wrench at a bracket to the point from which p leads
/// there.
template <ColumnOf<space::kPosition> P, ColumnOf<space::kTwist> F>
space::Twist translate(const Eigen::MatrixBase<P>& p, const Eigen::MatrixBase<F>& f) {
  space::Twist felt = f;
  angular(felt) += cross(p, linear(felt));
  return felt;
}

/// X a with X = [1, p~; 0, 1] = T^-1: the acceleration of a bracket, referred to the point from
/// which p leads there. It is linear: the centripetal term of a rotating p is not included.
template <ColumnOf<space::kPosition> P, ColumnOf<space::kTwist> A>
space::Twist refer(const Eigen::MatrixBase<P>& p, const Eigen::MatrixBase<A>& a) {
  space::Twist referred = a;
  linear(referred) += cross(p, angular(referred));
  return referred;
}

namespace space {
using spoke::angular;
using spoke::cross;
using spoke::linear;
using spoke::refer;
using spoke::translate;
}  // namespace space

}  // namespace spoke
