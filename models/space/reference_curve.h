#pragma once

// The reference curve of a blade: straight along x, or bent before any load by given offsets along
// y and z, between which it is a natural cubic spline.

#include <vector>

#include "models/space/rotation.h"

namespace spoke::space {

/// The smallest rotation that takes the direction `from` to the direction `to`. Preconditions: both
/// of length 1 and not opposite.
Rotation smallest_rotation(const Position& from, const Position& to);

class ReferenceCurve {
 public:
  /// Straight along x.
  ReferenceCurve() = default;
  /// Through the points, given in the blade's frame. Precondition: x ascends; two or more points.
  explicit ReferenceCurve(std::vector<Position> points);

  bool is_straight() const { return points_.empty(); }
  /// Where one cubic ends and the next begins.
  const std::vector<Position>& points() const { return points_; }
  /// The point at x [m]. Beyond the points, the first and the last cubic go on.
  Position at(double x) const;
  /// Its change with x.
  Position slope(double x) const;

 private:
  std::size_t interval(double x) const;

  std::vector<Position> points_;
  std::vector<Position> curvature_;  ///< second derivatives with x at the points; x is 0
};

}  // namespace spoke::space
