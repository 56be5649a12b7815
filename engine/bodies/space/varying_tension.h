#pragma once

// How the change of tension along an element acts on its slopes: see nonlinear_strain.h.

#include "engine/bodies/space/plane_coordinates.h"

namespace spoke::space {

/// Weights by which psi of the node between two elements takes their h: lengths weigh, and the
/// first and the last element of a body count whole.
struct ShiftWeights {
  double inboard, outboard;
};
inline ShiftWeights shift_weights(const FlexibleBody& body, int node) {
  assert(node > 0 && node < body.elements);
  const double a = body.beam[static_cast<std::size_t>(node - 1)].length;
  const double b = body.beam[static_cast<std::size_t>(node)].length;
  return {(node == 1 ? 2.0 : 1.0) * a / (a + b),
          (node + 1 == body.elements ? 2.0 : 1.0) * b / (a + b)};
}

/// Returns h of an element from its slopes [m].
inline double calc_slope_moment(const BeamElement& element, const PlaneCoordinates& x) {
  const Double2 a = x.slope[0], b = x.slope[1];
  const Double2 h = (3.0 * x.rise * (b - a) + element.length * (b * b - a * a)) / 60.0;
  return h[0] + h[1];
}
/// Returns its rate.
inline double calc_slope_moment_rate(const BeamElement& element, const PlaneCoordinates& x,
                                     const PlaneCoordinates& rate) {
  const Double2 a = x.slope[0], b = x.slope[1], a_rate = rate.slope[0], b_rate = rate.slope[1];
  const Double2 h = (3.0 * (rate.rise * (b - a) + x.rise * (b_rate - a_rate)) +
                     2.0 * element.length * (b * b_rate - a * a_rate)) /
                    60.0;
  return h[0] + h[1];
}
/// Returns factor times dh by the slopes.
inline PlaneCoordinates differ_slope_moment(const BeamElement& element, double factor,
                                            const PlaneCoordinates& x) {
  const Double2 a = x.slope[0], b = x.slope[1];
  const double by_60 = factor / 60.0;
  return {by_60 * 3.0 * (b - a),
          {-by_60 * (3.0 * x.rise + 2.0 * element.length * a),
           by_60 * (3.0 * x.rise + 2.0 * element.length * b)},
          {}};
}

/// Adds factor times the second derivatives of h by the coordinates of both nodes, which are
/// constant; slopes are the rotation x the element's axis.
inline void add_slope_curvature(const BeamElement& element, double factor,
                                Eigen::Matrix<double, 2 * kTwist, 2 * kTwist>& sum) {
  const Position axis = element.axes.col(0);
  const Matrix3 rise = factor / 20.0 * skew(axis);
  const Matrix3 slope =
      factor * element.length / 30.0 * (Matrix3::Identity() - axis * axis.transpose());
  constexpr int kOuter = kTwist + kRotation;
  const auto add = [&sum](int row, int column, const Matrix3& block) {
    sum.block<3, 3>(row, column) += block;
    sum.block<3, 3>(column, row) += block.transpose();
  };
  add(kRotation, 0, rise);
  add(kRotation, kTwist, -rise);
  add(kOuter, 0, -rise);
  add(kOuter, kTwist, rise);
  sum.block<3, 3>(kRotation, kRotation) -= slope;
  sum.block<3, 3>(kOuter, kOuter) += slope;
}

}  // namespace spoke::space
