// Finds the elements under a load.

#include "models/system/blade_loads.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spoke {
namespace {

/// A blade's elements, all of one length.
struct Mesh {
  explicit Mesh(const Blade& blade)
      : elements(blade.elements),
        count(blade.bodies * blade.elements),
        length(blade.length / count) {}

  int elements;   ///< of a body
  int count;      ///< of the blade
  double length;  ///< of each [m]
};

/// A point on the body that it lies on.
struct PlacedPoint {
  std::size_t body = 0;
  LoadPoint point;
};

/// `s` within element `e` of the blade.
PlacedPoint place(int e, double s, double weight, const Mesh& mesh) {
  const int element = e % mesh.elements;
  return {static_cast<std::size_t>(e / mesh.elements),
          {element, s, (element + s) * mesh.length, weight}};
}

/// A distance from the root. Within round-off of a node that is the node, and of two elements that
/// meet there the inner one.
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

/// The points between two stations, root to tip.
std::vector<PlacedPoint> place(double from, double to, const Mesh& mesh) {
  // Gauss's rule of four on [0, 1].
  static constexpr std::array<double, 4> places{0.06943184420297371, 0.33000947820757187,
                                                0.66999052179242813, 0.93056815579702629};
  static constexpr std::array<double, 4> weights{0.17392742256872693, 0.32607257743127307,
                                                 0.32607257743127307, 0.17392742256872693};
  std::vector<PlacedPoint> points;
  const int first = std::max(0, static_cast<int>(from / mesh.length) - 1);
  for (int e = first; e < mesh.count && e * mesh.length < to; ++e) {
    const double begin = std::max(from / mesh.length - e, 0.0);
    const double share = std::min(to / mesh.length - e, 1.0) - begin;
    if (share <= 1e-9) continue;  // round-off
    for (std::size_t k = 0; k < places.size(); ++k)
      points.push_back(place(e, begin + places[k] * share, weights[k] * share * mesh.length, mesh));
  }
  return points;
}

/// Adds a copy of `load` with the points on it to each body that has any.
template <class Load>
void add(const std::vector<PlacedPoint>& points, const Load& load,
         std::vector<Load> ChainBody::*member, Subsystem& subsystem) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t last = none;
  for (const PlacedPoint& placed : points) {
    std::vector<Load>& loads = subsystem.bodies[placed.body].*member;
    if (placed.body != last) loads.push_back(load);
    last = placed.body;
    loads.back().points.push_back(placed.point);
  }
}

/// Calls `apply(mesh, blade, subsystem)` for each blade that a load acts on.
template <class Load, class Apply>
void for_loaded(const Load& load, const Rotor& rotor, System& system, Apply&& apply) {
  for (std::size_t i = 0; i < rotor.blades.size(); ++i)
    if (load.blade.holds(i)) apply(Mesh(rotor.blades[i]), rotor.blades[i], system.subsystems[i]);
}

std::shared_ptr<const LoadCourse> make_course(const Curve& factor, double ramp) {
  return std::make_shared<const LoadCourse>(LoadCourse{factor, ramp});
}

void place_drag(const Drag& drag, const Rotor& rotor, System& system) {
  const auto course = make_course(drag.factor, drag.ramp);
  const BodyDrag at_point{{}, drag.relative_to, drag.linear, drag.quadratic, course};
  const BodyDrag along{
      {}, drag.relative_to, drag.linear_per_length, drag.quadratic_per_length, course};
  for_loaded(drag, rotor, system, [&](const Mesh& mesh, const Blade& blade, Subsystem& subsystem) {
    if (drag.linear != 0.0 || drag.quadratic != 0.0)
      add({place(drag.position.value_or(blade.length), mesh)}, at_point, &ChainBody::drags,
          subsystem);
    if (drag.linear_per_length != 0.0 || drag.quadratic_per_length != 0.0)
      add(place(drag.from, drag.to.value_or(blade.length), mesh), along, &ChainBody::drags,
          subsystem);
  });
}

}  // namespace

void place_loads(const Rotor& rotor, System& system) {
  for (const PointLoad& load : rotor.loads) {
    const BodyLoad on_body{
        {}, load.frame, load.force, load.moment, make_course(load.factor, load.ramp)};
    for_loaded(load, rotor, system, [&](const Mesh& mesh, const Blade& blade, Subsystem& to) {
      add({place(load.position.value_or(blade.length), mesh)}, on_body, &ChainBody::loads, to);
    });
  }
  for (const DistributedLoad& load : rotor.distributed_loads) {
    const BodyLoad on_body{{},
                           load.frame,
                           load.force_per_length,
                           load.moment_per_length,
                           make_course(load.factor, load.ramp)};
    for_loaded(load, rotor, system, [&](const Mesh& mesh, const Blade& blade, Subsystem& to) {
      add(place(load.from, load.to.value_or(blade.length), mesh), on_body, &ChainBody::loads, to);
    });
  }
  for (const Drag& drag : rotor.drags) place_drag(drag, rotor, system);
}

}  // namespace spoke
