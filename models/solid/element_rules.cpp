#include "models/solid/element_rules.h"

#include <cassert>
#include <cmath>

namespace spoke::solid {
namespace {

/// A place of [-1, 1] and its weight.
struct LinePoint {
  double place, weight;
};

/// Gauss's rules by their closed forms.
std::vector<LinePoint> gauss_points(int points) {
  if (points == 2) {
    const double a = std::sqrt(1.0 / 3.0);
    return {{-a, 1.0}, {a, 1.0}};
  }
  if (points == 3) {
    const double a = std::sqrt(0.6);
    return {{-a, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {a, 5.0 / 9.0}};
  }
  assert(points == 5);
  const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
  const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
  const double w_inner = (322.0 + 13.0 * std::sqrt(70.0)) / 900.0;
  const double w_outer = (322.0 - 13.0 * std::sqrt(70.0)) / 900.0;
  return {{-outer, w_outer},
          {-inner, w_inner},
          {0.0, 128.0 / 225.0},
          {inner, w_inner},
          {outer, w_outer}};
}

/// Adds the four places whose barycentric coordinates are a, a, a and 1 - 3 a.
void add_corner_orbit(double a, double weight, std::vector<ParentPoint>& points) {
  const double b = 1.0 - 3.0 * a;
  points.push_back({{a, a, a}, weight});
  points.push_back({{b, a, a}, weight});
  points.push_back({{a, b, a}, weight});
  points.push_back({{a, a, b}, weight});
}

/// Adds the six places whose barycentric coordinates are a, a, 1/2 - a and 1/2 - a.
void add_side_orbit(double a, double weight, std::vector<ParentPoint>& points) {
  const double b = 0.5 - a;
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(a, b, b), Eigen::Vector3d(b, a, b), Eigen::Vector3d(b, b, a),
        Eigen::Vector3d(b, a, a), Eigen::Vector3d(a, b, a), Eigen::Vector3d(a, a, b)})
    points.push_back({place, weight});
}

}  // namespace

std::vector<ParentPoint> tetrahedron_1() { return {{Eigen::Vector3d::Constant(0.25), 1.0 / 6.0}}; }

std::vector<ParentPoint> tetrahedron_4() {
  std::vector<ParentPoint> points;
  add_corner_orbit((5.0 - std::sqrt(5.0)) / 20.0, 1.0 / 24.0, points);
  return points;
}

std::vector<ParentPoint> tetrahedron_14() {
  std::vector<ParentPoint> points;
  add_corner_orbit(0.31088591926330060980, 0.018781320953002641800, points);
  add_corner_orbit(0.092735250310891226402, 0.012248840519393658257, points);
  add_side_orbit(0.045503704125649649492, 0.0070910034628469110730, points);
  return points;
}

std::vector<ParentPoint> tetrahedron_125() {
  const std::vector<LinePoint> line = gauss_points(5);
  std::vector<ParentPoint> points;
  // The cube's sides at u = 1 and v = 1 shrink to a corner and a side.
  for (const LinePoint& p : line) {
    for (const LinePoint& q : line) {
      for (const LinePoint& r : line) {
        const double u = 0.5 * (1.0 + p.place), v = 0.5 * (1.0 + q.place),
                     w = 0.5 * (1.0 + r.place);
        points.push_back(
            {{u, (1.0 - u) * v, (1.0 - u) * (1.0 - v) * w},
             0.125 * p.weight * q.weight * r.weight * (1.0 - u) * (1.0 - u) * (1.0 - v)});
      }
    }
  }
  return points;
}

std::vector<ParentPoint> cube_points(int points) {
  const std::vector<LinePoint> line = gauss_points(points);
  std::vector<ParentPoint> result;
  for (const LinePoint& p : line)
    for (const LinePoint& q : line)
      for (const LinePoint& r : line)
        result.push_back({{p.place, q.place, r.place}, p.weight * q.weight * r.weight});
  return result;
}

}  // namespace spoke::solid
