#pragma once

// The axis of a blade through key points, and its arc length, along which other programs give
// sections.

#include <string>
#include <vector>

#include "models/space/reference_curve.h"
#include "program/foreign/beam_table.h"

namespace spoke::foreign {

/// A point of the axis of a blade.
struct KeyPoint {
  double x = 0.0;        ///< along the blade [m]
  double sweep = 0.0;    ///< y of the axis [m]
  double prebend = 0.0;  ///< z of the axis [m]
  double twist = 0.0;    ///< about +x [rad]
  std::string from{};
};

/// Returns whether a point is at the root but for what rounding left.
bool is_at_root(const KeyPoint& point);

/// Natural cubic splines through key points: of the axis and of the twist.
class BladeAxis {
 public:
  /// Precondition: two or more points, whose x ascends from 0.
  explicit BladeAxis(std::vector<KeyPoint> points);

  const std::vector<KeyPoint>& points() const { return points_; }
  KeyPoint at(double x) const;
  /// Returns the arc length from the root to x [m].
  double arc_length(double x) const;
  double whole_arc_length() const { return lengths_.back(); }
  /// Returns the x at which the arc length is so much, 0 to all of it.
  double find_x(double arc_length) const;

 private:
  double measure(double from, double to) const;

  std::vector<KeyPoint> points_;
  space::ReferenceCurve axis_, twist_;
  std::vector<double> lengths_;  ///< arc lengths from the root to the points
};

/// Properties of a section in BeamDyn's axes, at a share of the arc length.
struct FoundSection {
  double eta = 0.0;  ///< 0 at the root, 1 at the tip
  SectionMatrix stiffness = SectionMatrix::Zero(), mass = SectionMatrix::Zero();
  std::string from{};
};

/// Returns the beam with stations at all key points and sections; matrices between sections are
/// linear in arc length, as BeamDyn has them. Precondition: eta of the sections ascends from 0
/// to 1.
BeamTable merge_stations(const BladeAxis& axis, const std::vector<FoundSection>& sections);

}  // namespace spoke::foreign
