#pragma once

// Rotations and poses in space, by the names of the plane's (models/plane/plane.h).

#include "models/space/vectors.h"

namespace spoke::space {

/// Rotation R_AB in space: takes components resolved in frame B to frame A.
struct Rotation {
  Matrix3 axes = Matrix3::Identity();  ///< columns: the axes of B, resolved in A

  Rotation inverse() const { return {axes.transpose()}; }

  Position operator*(const Position& v) const { return axes.lazyProduct(v); }
  Rotation operator*(const Rotation& other) const { return {axes.lazyProduct(other.axes)}; }
  /// Both parts of a twist or wrench are turned.
  Twist operator*(const Twist& v) const {
    Twist turned;
    linear(turned) = axes.lazyProduct(linear(v));
    angular(turned) = axes.lazyProduct(angular(v));
    return turned;
  }
  TwistMatrix matrix() const {
    TwistMatrix m = TwistMatrix::Zero();
    m.topLeftCorner<3, 3>() = axes;
    m.bottomRightCorner<3, 3>() = axes;
    return m;
  }
};

/// Position and orientation of frame B in frame A.
struct Pose {
  Position p = Position::Zero();  ///< origin of B, resolved in A [m]
  Rotation R;                     ///< R_AB
};

}  // namespace spoke::space
