#pragma once

// The differential equations of a beam in space, integrated along it, as a reference for its finite
// elements. The two share only sections and reference curve.

#include <Eigen/Core>
#include <vector>

#include "models/space/beam.h"

namespace spoke::space::test {

/// Returns mass, first and second moment of a beam about a frame, by Simpson's rule.
MassMoments integrate_mass(const Beam& beam, const Pose& frame);

/// Returns displacement and rotation of the tip of a clamped beam under a wrench there, all in
/// `frame`.
Twist solve_statics(const Beam& beam, const Pose& frame, const Twist& wrench);

/// A beam clamped at its first station, free at its last, that vibrates.
class BeamEquations {
 public:
  BeamEquations(const Beam& beam, int steps);

  /// Returns the natural frequency next to a guess that is right within a percent [rad/s].
  double find_frequency(double guess) const;

 private:
  using State = Eigen::Matrix<double, 12, 6>;  ///< (u, th, F, M) for six unit vectors at the root
  struct Point {
    SectionAt at;
    SectionMatrices section;
  };

  State derivative(const Point& point, double squared_frequency, const State& state) const;
  /// Returns the determinant of the map from root wrenches to tip wrenches: 0 at a natural
  /// frequency.
  double determinant(double frequency) const;

  std::vector<double> widths_;  ///< widths of the steps [m]
  std::vector<Point> points_;   ///< at the steps' beginnings, middles and ends: 3 each
};

}  // namespace spoke::space::test
