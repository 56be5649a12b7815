// The natural cubic spline through the points of a bent blade.

#include "models/space/reference_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::space {

Rotation smallest_rotation(const Position& from, const Position& to) {
  const Matrix3 v = skew(cross(from, to));
  const double cosine = from.dot(to);
  assert(cosine > -1.0);
  assert(std::abs(from.squaredNorm() - 1.0) < 1e-9 && std::abs(to.squaredNorm() - 1.0) < 1e-9);
  return {Matrix3::Identity() + v + v * v / (1.0 + cosine)};
}

ReferenceCurve::ReferenceCurve(std::vector<Position> points)
    : points_(std::move(points)), curvature_(points_.size(), Position::Zero()) {
  assert(points_.size() > 1);
  assert(std::adjacent_find(points_.begin(), points_.end(), [](const auto& a, const auto& b) {
           return !(a.x() < b.x());
         }) == points_.end());
  // Second derivatives M_k of a natural spline: h_k M_k-1 + 2 (h_k + h_k+1) M_k + h_k+1 M_k+1 =
  // 6 (slope_k+1 - slope_k), and none at the ends. Eliminated from the front.
  const std::size_t n = points_.size();
  const auto width = [this](std::size_t k) { return points_[k + 1].x() - points_[k].x(); };
  const auto chord_slope = [&](std::size_t k) -> Position {
    return (points_[k + 1] - points_[k]) / width(k);
  };
  std::vector<double> pivot(n, 1.0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double factor = k > 1 ? width(k - 1) / pivot[k - 1] : 0.0;
    pivot[k] = 2.0 * (width(k - 1) + width(k)) - factor * width(k - 1);
    curvature_[k] = 6.0 * (chord_slope(k) - chord_slope(k - 1)) - factor * curvature_[k - 1];
  }
  for (std::size_t k = n - 1; k-- > 1;)
    curvature_[k] = (curvature_[k] - width(k) * curvature_[k + 1]) / pivot[k];
}

std::size_t ReferenceCurve::interval(double x) const {
  const auto beyond =
      std::upper_bound(points_.begin() + 1, points_.end() - 1, x,
                       [](double place, const Position& point) { return place < point.x(); });
  return static_cast<std::size_t>(beyond - points_.begin()) - 1;
}

Position ReferenceCurve::at(double x) const {
  if (is_straight()) return {x, 0.0, 0.0};
  const std::size_t k = interval(x);
  const double h = points_[k + 1].x() - points_[k].x();
  const double b = (x - points_[k].x()) / h, a = 1.0 - b;
  return a * points_[k] + b * points_[k + 1] +
         (h * h / 6.0) * ((a * a * a - a) * curvature_[k] + (b * b * b - b) * curvature_[k + 1]);
}

Position ReferenceCurve::slope(double x) const {
  if (is_straight()) return Position::UnitX();
  const std::size_t k = interval(x);
  const double h = points_[k + 1].x() - points_[k].x();
  const double b = (x - points_[k].x()) / h, a = 1.0 - b;
  return (points_[k + 1] - points_[k]) / h + (h / 6.0) * ((1.0 - 3.0 * a * a) * curvature_[k] +
                                                          (3.0 * b * b - 1.0) * curvature_[k + 1]);
}

}  // namespace spoke::space
