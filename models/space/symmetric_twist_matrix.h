#pragma once

// Masses and compliances in space: symmetric maps between twists and wrenches, by blocks of three.

#include "models/space/rotation.h"

namespace spoke::space {

/// A symmetric twist matrix (mass, compliance) [tt, rt^T; rt, rr] of translation (t) and rotation
/// (r).
struct SymmetricTwistMatrix {
  Matrix3 tt = Matrix3::Zero();  ///< symmetric
  Matrix3 rt = Matrix3::Zero();  ///< rows: rotation, columns: translation
  Matrix3 rr = Matrix3::Zero();  ///< symmetric

  /// The symmetric matrix of which `m` holds at least the lower left block and both diagonal ones.
  static SymmetricTwistMatrix from_matrix(const TwistMatrix& m) {
    return {m.topLeftCorner<3, 3>(), m.bottomLeftCorner<3, 3>(), m.bottomRightCorner<3, 3>()};
  }
  TwistMatrix matrix() const {
    TwistMatrix m;
    m << tt, rt.transpose(), rt, rr;
    return m;
  }
  SymmetricTwistMatrix operator+(const SymmetricTwistMatrix& b) const {
    return {tt + b.tt, rt + b.rt, rr + b.rr};
  }
  SymmetricTwistMatrix operator-(const SymmetricTwistMatrix& b) const {
    return {tt - b.tt, rt - b.rt, rr - b.rr};
  }
  Twist operator*(const Twist& v) const {
    Twist result;
    linear(result) = tt.lazyProduct(linear(v)) + rt.transpose().lazyProduct(angular(v));
    angular(result) = rt.lazyProduct(linear(v)) + rr.lazyProduct(angular(v));
    return result;
  }
};

/// R A R^T: a matrix resolved in frame B, to frame A.
inline SymmetricTwistMatrix rotate(const Rotation& R, const SymmetricTwistMatrix& a) {
  const auto turn = [&R](const Matrix3& block) -> Matrix3 {
    const Matrix3 half = R.axes.lazyProduct(block);
    return half.lazyProduct(R.axes.transpose());
  };
  return {turn(a.tt), turn(a.rt), turn(a.rr)};
}

/// T^T A T with T = [1, -p~; 0, 1]: a mass at a bracket, as felt at the point from which p leads
/// there.
inline SymmetricTwistMatrix translate(const Position& p, const SymmetricTwistMatrix& a) {
  const Matrix3 rt = a.rt + cross_columns(p, a.tt);
  // m p~ = -(p~ m^T)^T.
  return {a.tt, rt,
          a.rr + cross_columns(p, a.rt.transpose()) + cross_columns(p, rt.transpose()).transpose()};
}

/// X A X^T with X = [1, p~; 0, 1]: a compliance at a bracket, referred to the point from which p
/// leads there. The inverse of what translate() makes of the inverse.
inline SymmetricTwistMatrix refer(const Position& p, const SymmetricTwistMatrix& a) {
  const Matrix3 once = cross_columns(p, a.rt);
  const Matrix3 rt = a.rt + cross_columns(p, a.rr).transpose();
  return {a.tt + cross_columns(p, rt) + once.transpose(), rt, a.rr};
}

/// A - factor y y^T.
inline SymmetricTwistMatrix subtract_square(const SymmetricTwistMatrix& a, const Twist& y,
                                            double factor) {
  const Twist scaled = factor * y;
  return {a.tt - linear(scaled) * linear(y).transpose(),
          a.rt - angular(scaled) * linear(y).transpose(),
          a.rr - angular(scaled) * angular(y).transpose()};
}

/// Inverse of a symmetric matrix of three by its cofactors, of which it reads the lower triangle.
/// Not finite if it is singular.
inline Matrix3 invert_symmetric(const Matrix3& a) {
  const double xx = a(0, 0), yx = a(1, 0), zx = a(2, 0), yy = a(1, 1), zy = a(2, 1), zz = a(2, 2);
  const double c00 = yy * zz - zy * zy;
  const double c10 = zx * zy - yx * zz;
  const double c20 = yx * zy - yy * zx;
  const double scale = 1.0 / (xx * c00 + yx * c10 + zx * c20);
  const double c11 = xx * zz - zx * zx;
  const double c21 = yx * zx - xx * zy;
  const double c22 = xx * yy - yx * yx;
  Matrix3 inverse;
  inverse << c00, c10, c20, c10, c11, c21, c20, c21, c22;
  return scale * inverse;
}

/// Inverse of a positive definite matrix, of whose block tt the inverse is known. Not finite if it
/// is singular.
inline SymmetricTwistMatrix invert(const SymmetricTwistMatrix& a, const Matrix3& tt_inverse) {
  // By the Schur complement rr - rt tt^-1 rt^T.
  const Matrix3 y = a.rt.lazyProduct(tt_inverse);
  const Matrix3 rr = invert_symmetric(a.rr - y.lazyProduct(a.rt.transpose()));
  const Matrix3 rt = -rr.lazyProduct(y);
  return {tt_inverse - y.transpose().lazyProduct(rt), rt, rr};
}
inline SymmetricTwistMatrix invert(const SymmetricTwistMatrix& a) {
  return invert(a, invert_symmetric(a.tt));
}

/// C - A B A^T: what eliminating a joint of compliance B^-1 leaves of C.
inline SymmetricTwistMatrix eliminate(const SymmetricTwistMatrix& c, const TwistMatrix& a,
                                      const SymmetricTwistMatrix& b) {
  const TwistMatrix ab = a.lazyProduct(b.matrix());
  // All of it: columns of six are products of pairs, blocks of three are not.
  return c - SymmetricTwistMatrix::from_matrix(ab.lazyProduct(a.transpose()));
}

}  // namespace spoke::space
