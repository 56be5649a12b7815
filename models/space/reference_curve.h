#pragma once

// The reference curve of a blade: straight along x, or bent before any load by given offsets along
// y and z, between which it is a natural cubic spline.

#include <vector>

#include "models/space/rotation.h"

namespace spoke::space {

/// Returns the smallest rotation that takes the direction `from` to the direction `to`.
/// Preconditions: both of length 1 and not opposite.
Rotation smallest_rotation(const Position& from, const Position& to);

class ReferenceCurve {
 public:
  /// Makes a curve that is straight along x.
  ReferenceCurve() = default;
  /// Makes the curve through the points, given in the blade's frame. Precondition: x ascends; two
  /// or more points.
  explicit ReferenceCurve(std::vector<Position> points);

  bool is_straight() const { return points_.empty(); }
  /// Returns the points, where one cubic ends and the next begins.
  const std::vector<Position>& points() const { return points_; }
  /// Returns the point at x [m]. Beyond the points, the first and the last cubic go on.
  Position at(double x) const;
  /// Returns its derivative by x.
  Position slope(double x) const;

 private:
  std::size_t interval(double x) const;

  std::vector<Position> points_;
  /// Second derivatives by x at the points; the x component is 0.
  std::vector<Position> curvature_;
};

}  // namespace spoke::space
