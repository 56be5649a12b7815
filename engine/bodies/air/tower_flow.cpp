// Flow around a cylinder in the plane across a tower's axis, at the point nearest to a place.

#include "engine/bodies/air/tower_flow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace spoke::air {
namespace {

using Eigen::Vector3d;

/// The point of an axis that is nearest to a place, and how far beyond its ends the place is.
struct AxisPoint {
  TowerPoint point;
  Vector3d direction;   ///< of the axis, a unit vector
  double beyond = 0.0;  ///< along the axis [m]
};

AxisPoint find_nearest(std::span<const TowerPoint> axis, const Vector3d& place) noexcept {
  AxisPoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < axis.size(); ++k) {
    const TowerPoint &a = axis[k - 1], &b = axis[k];
    const Vector3d along = b.position - a.position;
    const double length = along.norm();
    const double share = (place - a.position).dot(along) / (length * length);
    const double within = std::clamp(share, 0.0, 1.0);
    const double distance = (place - a.position - within * along).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest.point = {a.position + within * along, (1.0 - within) * a.velocity + within * b.velocity,
                     (1.0 - within) * a.diameter + within * b.diameter,
                     (1.0 - within) * a.coefficient + within * b.coefficient};
    nearest.direction = along / length;
    const bool is_at_end = (k == 1 && share < 0.0) || (k + 1 == axis.size() && share > 1.0);
    nearest.beyond = is_at_end ? std::abs(share - within) * length : 0.0;
  }
  return nearest;
}

}  // namespace

CylinderFlow calc_cylinder_flow(const TowerFlow& flow, double x, double y,
                                double coefficient) noexcept {
  using spatial::TowerPotential, spatial::TowerShadow;
  const double size = std::hypot(x, y);
  if (!(size > 0.0)) x = -1.0;
  if (size > 0.0 && size < 1.0) {
    x /= size;
    y /= size;
  }
  CylinderFlow added;
  if (flow.potential != TowerPotential::none) {
    constexpr double shift = 0.1;  // of Bak's source, by the radius
    const bool is_bak = flow.potential == TowerPotential::bak;
    const double ahead = is_bak ? x + shift : x;
    const double square = ahead * ahead + y * y;
    added.along = (y * y - ahead * ahead) / (square * square);
    added.across = -2.0 * ahead * y / (square * square);
    if (is_bak) {
      const double source = coefficient / (2.0 * std::numbers::pi * square);
      added.along += source * ahead;
      added.across += source * y;
    }
  }
  if (flow.shadow == TowerShadow::powles && x > 0.0) {
    const double width = std::sqrt(std::hypot(x, y));  // half, by the radius
    if (std::abs(y) < width) {
      const double shape = std::cos(0.5 * std::numbers::pi * y / width);
      added.along -= coefficient / width * shape * shape;
    }
  }
  return added;
}

Vector3d calc_tower_flow(const TowerFlow& flow, std::span<const TowerPoint> axis,
                         const Vector3d& place, const Vector3d& wind) noexcept {
  assert(axis.size() >= 2);
  const AxisPoint nearest = find_nearest(axis, place);
  const double radius = 0.5 * nearest.point.diameter;
  if (!(radius > nearest.beyond)) return Vector3d::Zero();
  const auto across = [&nearest](const Vector3d& v) -> Vector3d {
    return v - v.dot(nearest.direction) * nearest.direction;
  };
  const Vector3d blown = across(wind - nearest.point.velocity);
  const double speed = blown.norm();
  if (!(speed > 0.0)) return Vector3d::Zero();
  const Vector3d along = blown / speed;
  const Vector3d beside = nearest.direction.cross(along);
  const Vector3d arm = across(place - nearest.point.position) / radius;
  const CylinderFlow added =
      calc_cylinder_flow(flow, arm.dot(along), arm.dot(beside), nearest.point.coefficient);
  const double fade = std::cos(0.5 * std::numbers::pi * nearest.beyond / radius);
  return speed * fade * fade * (added.along * along + added.across * beside);
}

}  // namespace spoke::air
