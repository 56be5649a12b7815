// Finds the elements under a load.

#include "models/system/blade_loads.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "models/support/gauss_rule.h"

namespace spoke {
namespace {

/// A blade's elements, all of one length.
struct Mesh {
  explicit Mesh(const Blade& blade)
      : elements(blade.elements),
        count(blade.bodies * blade.elements),
        length(blade.length / count) {}

  int elements;   ///< elements of a body
  int count;      ///< elements of the blade
  double length;  ///< length of each element [m]
};

/// A point on the body that it lies on.
struct PlacedPoint {
  std::size_t body = 0;
  LoadPoint point;
};

/// Returns the point at `s` within element `e` of the blade.
PlacedPoint place(int e, double s, double weight, const Mesh& mesh) {
  assert(e >= 0 && e < mesh.count && s >= -1e-9 && s <= 1.0 + 1e-9);
  const int element = e % mesh.elements;
  return {static_cast<std::size_t>(e / mesh.elements),
          {element, s, (element + s) * mesh.length, weight}};
}

/// Returns the point at a distance from the root; within round-off of a node it is the node, in the
/// inner one of the elements that meet there.
PlacedPoint place(double position, const Mesh& mesh) {
  const double along = position / mesh.length;
  const double node = std::round(along);
  if (std::abs(along - node) <= 1e-9 * std::max(1.0, along)) {
    const int e = std::clamp(static_cast<int>(node) - 1, 0, mesh.count - 1);
    return place(e, node - e, 1.0, mesh);
  }
  const int e = std::min(static_cast<int>(along), mesh.count - 1);
  return place(e, along - e, 1.0, mesh);
}

/// Returns the points between two stations, root to tip.
std::vector<PlacedPoint> place(double from, double to, const Mesh& mesh) {
  std::vector<PlacedPoint> points;
  const int first = std::max(0, static_cast<int>(from / mesh.length) - 1);
  for (int e = first; e < mesh.count && e * mesh.length < to; ++e) {
    const double begin = std::max(from / mesh.length - e, 0.0);
    const double share = std::min(to / mesh.length - e, 1.0) - begin;
    if (share <= 1e-9) continue;  // round-off
    const double inboard = (e % mesh.elements + begin) * mesh.length;
    const std::array<double, 2> stretch{inboard, inboard + share * mesh.length};
    for (std::size_t k = 0; k < GaussRule<4>::kPoints; ++k) {
      points.push_back(place(e, begin + GaussRule<4>::places[k] * share,
                             GaussRule<4>::weights[k] * share * mesh.length, mesh));
      points.back().point.stretch = stretch;
    }
  }
  return points;
}

/// Adds a copy of `load` with the points on it to each body that has any.
template <class Load>
void add(const std::vector<PlacedPoint>& points, const Load& load,
         std::vector<Load> BodyLoads<Plane>::*member, std::vector<BodyLoads<Plane>>& bodies) {
  std::size_t last = bodies.size();
  for (const PlacedPoint& placed : points) {
    std::vector<Load>& loads = bodies[placed.body].*member;
    if (placed.body != last) loads.push_back(load);
    last = placed.body;
    loads.back().points.push_back(placed.point);
  }
}

template <class Load>
std::shared_ptr<LoadCourse> course_of(const Load& load) {
  return std::make_shared<LoadCourse>(LoadCourse{load.factor, load.ramp, load.name});
}

void add_drag(const Drag& drag, const Mesh& mesh, double tip,
              std::vector<BodyLoads<Plane>>& bodies) {
  const auto course = course_of(drag);
  if (drag.linear != 0.0 || drag.quadratic != 0.0)
    add({place(drag.position.value_or(tip), mesh)},
        BodyDrag<Plane>{{}, drag.relative_to, drag.linear, drag.quadratic, course},
        &BodyLoads<Plane>::drags, bodies);
  if (drag.linear_per_length != 0.0 || drag.quadratic_per_length != 0.0)
    add(place(drag.from, drag.to.value_or(tip), mesh),
        BodyDrag<Plane>{
            {}, drag.relative_to, drag.linear_per_length, drag.quadratic_per_length, course},
        &BodyLoads<Plane>::drags, bodies);
}

}  // namespace

std::vector<BodyLoads<Plane>> make_body_loads(const Rotor& rotor, std::size_t index) {
  assert(index < rotor.blades.size());
  const Blade& blade = rotor.blades[index];
  const Mesh mesh(blade);
  const double tip = blade.length;
  std::vector<BodyLoads<Plane>> bodies(static_cast<std::size_t>(blade.bodies));
  for (const PointLoad& load : rotor.loads)
    if (load.blade.holds(index))
      add({place(load.position.value_or(tip), mesh)},
          BodyLoad<Plane>{{}, load.frame, load.force, load.moment, course_of(load)},
          &BodyLoads<Plane>::loads, bodies);
  for (const DistributedLoad& load : rotor.distributed_loads)
    if (load.blade.holds(index))
      add(place(load.from, load.to.value_or(tip), mesh),
          BodyLoad<Plane>{
              {}, load.frame, load.force_per_length, load.moment_per_length, course_of(load)},
          &BodyLoads<Plane>::loads, bodies);
  for (const Drag& drag : rotor.drags)
    if (drag.blade.holds(index)) add_drag(drag, mesh, tip, bodies);
  return bodies;
}

}  // namespace spoke
