#pragma once

// Masses and compliances in space: symmetric maps between twists and wrenches.

#include "models/space/rotation.h"
#include "models/space/twist_columns.h"

namespace spoke::space {

/// A symmetric twist matrix (mass, compliance) [tt, rt^T; rt, rr] of translation (t) and rotation
/// (r). All of it is kept: products go by whole columns.
struct SymmetricTwistMatrix {
  TwistMatrix all = TwistMatrix::Zero();

  static SymmetricTwistMatrix from_blocks(const Matrix3& tt, const Matrix3& rt, const Matrix3& rr) {
    return {join_blocks(tt, rt, rr)};
  }
  /// Returns the symmetric matrix of which `m` holds at least the lower left block and both
  /// diagonal ones.
  static SymmetricTwistMatrix from_matrix(const TwistMatrix& m) {
    return from_blocks(m.topLeftCorner<3, 3>(), m.bottomLeftCorner<3, 3>(),
                       m.bottomRightCorner<3, 3>());
  }
  const TwistMatrix& matrix() const { return all; }
  Matrix3 tt() const { return all.topLeftCorner<3, 3>(); }      ///< symmetric
  Matrix3 rt() const { return all.bottomLeftCorner<3, 3>(); }   ///< rows: rotation
  Matrix3 rr() const { return all.bottomRightCorner<3, 3>(); }  ///< symmetric

  SymmetricTwistMatrix operator+(const SymmetricTwistMatrix& b) const {
    return {add(all, 1.0, b.all)};
  }
  SymmetricTwistMatrix operator-(const SymmetricTwistMatrix& b) const {
    return {add(all, -1.0, b.all)};
  }
  Twist operator*(const Twist& v) const { return multiply(all, v); }
};

/// R A R^T: converts a matrix resolved in frame B to frame A.
inline SymmetricTwistMatrix rotate(const Rotation& R, const SymmetricTwistMatrix& a) {
  return {turn_both(R.axes, a.all)};
}

/// T^T A T with T = [1, -p~; 0, 1]: refers a mass at a bracket to the point from which p leads
/// there.
inline SymmetricTwistMatrix translate(const Position& p, const SymmetricTwistMatrix& a) {
  const Matrix3 a_rt = a.rt();
  const Matrix3 rt = a_rt + cross_columns(p, a.tt());
  // m p~ = -(p~ m^T)^T.
  return SymmetricTwistMatrix::from_blocks(
      a.tt(), rt,
      a.rr() + cross_columns(p, a_rt.transpose()) + cross_columns(p, rt.transpose()).transpose());
}

/// X A X^T with X = [1, p~; 0, 1]: refers a compliance at a bracket to the point from which p leads
/// there. It is the inverse of translate() applied to the inverse.
inline SymmetricTwistMatrix refer(const Position& p, const SymmetricTwistMatrix& a) {
  const Matrix3 a_rt = a.rt(), rr = a.rr();
  const Matrix3 once = cross_columns(p, a_rt);
  const Matrix3 rt = a_rt + cross_columns(p, rr).transpose();
  return SymmetricTwistMatrix::from_blocks(a.tt() + cross_columns(p, rt) + once.transpose(), rt,
                                           rr);
}

/// A - factor y y^T.
inline SymmetricTwistMatrix subtract_square(const SymmetricTwistMatrix& a, const Twist& y,
                                            double factor) {
  const Twist scaled = factor * y;
  return {a.all - scaled.lazyProduct(y.transpose())};
}

/// Returns the inverse of a positive definite matrix; not finite if it is singular. The mean of
/// both halves is symmetric to the bit: an asymmetry due to rounding would grow from joint to
/// joint.
inline SymmetricTwistMatrix invert(const SymmetricTwistMatrix& a) {
  return {symmetric_mean(invert_definite(a.all))};
}

/// C - A B A^T: C after the elimination of a joint of compliance B^-1.
inline SymmetricTwistMatrix eliminate(const SymmetricTwistMatrix& c, const TwistMatrix& a,
                                      const SymmetricTwistMatrix& b) {
  // Only one half is computed, for the reason of invert().
  return {subtract_symmetric_product(c.all, multiply(a, b.all), a)};
}

}  // namespace spoke::space
