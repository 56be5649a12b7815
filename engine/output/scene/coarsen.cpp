// Collapses edges of a surface by quadrics of the planes of its triangles (Garland, Heckbert 1997),
// each to one of its ends.

#include "engine/output/scene/coarsen.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace spoke::scene {
namespace {

using spatial::Vector;

/// Weight of the fourth power of an edge's length beside the error: it keeps triangles even.
constexpr double kEvenness = 0.003;
/// Least cosine between the normals of a triangle before and after a collapse.
constexpr double kLeastTurn = 0.2;
constexpr double kSharp = 0.82;  // cosine of the least angle of an edge

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// A collapse: what it costs, and versions of its ends when it was found.
struct Collapse {
  double cost = 0.0;
  int from = 0, to = 0;
  int from_version = 0, to_version = 0;

  /// Whether it comes later in the queue; equal costs stand in the order of points.
  bool operator<(const Collapse& other) const {
    return std::tie(cost, from, to) > std::tie(other.cost, other.from, other.to);
  }
};

class Coarsening {
 public:
  Coarsening(const std::vector<Vector>& points, std::vector<Triangle> triangles)
      : points_(points),
        triangles_(std::move(triangles)),
        around_(points.size()),
        quadrics_(points.size(), Eigen::Matrix4d::Zero()),
        versions_(points.size(), 0),
        left_(triangles_.size()) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Vector normal = normal_of(triangles_[t]);  // its length is twice the area
      const double area = 0.5 * normal.norm();
      Eigen::Vector4d plane;
      plane << normal.normalized(), 0.0;
      plane[3] = -plane.head<3>().dot(points_[at(triangles_[t][0])]);
      for (const int corner : triangles_[t]) {
        around_[at(corner)].push_back(static_cast<int>(t));
        quadrics_[at(corner)] += area * plane * plane.transpose();
      }
    }
    for (int k = 0; k < static_cast<int>(points.size()); ++k) find_collapses(k);
  }

  std::vector<Triangle> run(std::size_t most) {
    while (left_ > most && !queue_.empty()) {
      const Collapse next = queue_.top();
      queue_.pop();
      const bool is_old = next.from_version != versions_[at(next.from)] ||
                          next.to_version != versions_[at(next.to)];
      if (!is_old && may_collapse(next.from, next.to)) collapse(next.from, next.to);
    }
    std::vector<Triangle> kept;
    for (const Triangle& triangle : triangles_)
      if (triangle[0] >= 0) kept.push_back(triangle);
    return kept;
  }

 private:
  Vector normal_of(const Triangle& t) const {
    const Vector& a = points_[at(t[0])];
    return (points_[at(t[1])] - a).cross(points_[at(t[2])] - a);
  }
  static bool has(const Triangle& t, int point) {
    return t[0] == point || t[1] == point || t[2] == point;
  }
  /// Returns the points that edges join to a point, ascending.
  std::vector<int> neighbours(int k) const {
    std::vector<int> found;
    for (const int t : around_[at(k)])
      for (const int corner : triangles_[at(t)])
        if (corner != k) found.push_back(corner);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  void find_collapses(int k) {
    for (const int other : neighbours(k)) {
      push(k, other);
      push(other, k);
    }
  }
  void push(int from, int to) {
    const Eigen::Matrix4d Q = quadrics_[at(from)] + quadrics_[at(to)];
    Eigen::Vector4d p;
    p << points_[at(to)], 1.0;
    const double square = (points_[at(from)] - points_[at(to)]).squaredNorm();
    queue_.push({p.dot(Q * p) + kEvenness * square * square, from, to, versions_[at(from)],
                 versions_[at(to)]});
  }

  /// Whether the surface stays one, and no triangle turns over.
  bool may_collapse(int from, int to) const {
    const std::vector<int> a = neighbours(from), b = neighbours(to);
    std::vector<int> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != 2) return false;
    for (const int t : around_[at(from)]) {
      Triangle moved = triangles_[at(t)];
      if (has(moved, to)) continue;
      const Vector before = normal_of(moved);
      std::replace(moved.begin(), moved.end(), from, to);
      const Vector after = normal_of(moved);
      if (before.dot(after) < kLeastTurn * before.norm() * after.norm() || after.isZero(0.0))
        return false;
    }
    return true;
  }
  void collapse(int from, int to) {
    const std::vector<int> changed = neighbours(from);
    for (const int t : around_[at(from)]) {
      Triangle& triangle = triangles_[at(t)];
      if (!has(triangle, to)) {
        std::replace(triangle.begin(), triangle.end(), from, to);
        around_[at(to)].push_back(t);
        continue;
      }
      for (const int corner : triangle)
        if (corner != from) std::erase(around_[at(corner)], t);
      triangle = {-1, -1, -1};
      --left_;
    }
    around_[at(from)].clear();
    quadrics_[at(to)] += quadrics_[at(from)];
    for (const int k : changed) ++versions_[at(k)];
    ++versions_[at(from)];
    for (const int k : changed) find_collapses(k);
  }

  const std::vector<Vector>& points_;
  std::vector<Triangle> triangles_;       ///< without points where they have gone
  std::vector<std::vector<int>> around_;  ///< triangles of each point
  std::vector<Eigen::Matrix4d> quadrics_;
  std::vector<int> versions_;
  std::size_t left_;
  std::priority_queue<Collapse> queue_;
};

}  // namespace

std::vector<Triangle> coarsen(const std::vector<Vector>& points, std::vector<Triangle> triangles,
                              std::size_t most) {
  if (triangles.size() <= most) return triangles;
  return Coarsening(points, std::move(triangles)).run(most);
}

std::vector<std::array<int, 2>> find_sharp_edges(const std::vector<Vector>& points,
                                                 const std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, std::vector<Vector>> normals;
  for (const Triangle& t : triangles) {
    const Vector& a = points[at(t[0])];
    const Vector normal = (points[at(t[1])] - a).cross(points[at(t[2])] - a).normalized();
    for (std::size_t k = 0; k < 3; ++k)
      normals[std::minmax(t[k], t[(k + 1) % 3])].push_back(normal);
  }
  std::vector<std::array<int, 2>> sharp;
  for (const auto& [edge, both] : normals)
    if (both.size() != 2 || both[0].dot(both[1]) < kSharp)
      sharp.push_back({edge.first, edge.second});
  return sharp;
}

}  // namespace spoke::scene
