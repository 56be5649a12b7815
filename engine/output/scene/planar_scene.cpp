// Makes the scene of a rotor in the plane z = 0.

#include <algorithm>
#include <cmath>

#include "engine/output/scene/carriers.h"
#include "engine/output/scene/make_scene.h"
#include "engine/output/scene/solids.h"
#include "models/plane/beam_properties.h"
#include "models/space/rotation_vector.h"

namespace spoke::scene {
namespace {

std::size_t count_nodes(const Rotor& rotor) {
  std::size_t nodes = 0;
  for (const Blade& blade : rotor.blades)
    nodes +=
        static_cast<std::size_t>(blade.bodies) * (static_cast<std::size_t>(blade.elements) + 1);
  return nodes;
}

/// Returns EI/EA at a place of a body of a blade [m^2].
double squared_gyration(const plane::BeamProperties& body, double x) {
  if (body.pieces.empty()) return body.bending_stiffness / body.axial_stiffness;
  const plane::BeamPiece& piece = piece_at(body.pieces, x);
  return piece.at(piece.bending_stiffness, x) / piece.at(piece.axial_stiffness, x);
}

/// Adds the blades, their loads and their sensors.
class PlanarScene {
 public:
  PlanarScene(const Scenario& scenario, std::size_t most_nodes)
      : scenario_(scenario), rotor_(scenario.rotor) {
    const std::size_t nodes = count_nodes(rotor_);
    stride_ = std::max<std::size_t>(1, (nodes + most_nodes - 1) / most_nodes);
    per_element_ = rings_per_element(nodes / stride_);
  }

  Scene make() && {
    scene_.is_planar = true;
    scene_.gravity = in_space(rotor_.gravity);
    for (std::size_t i = 0; i < rotor_.blades.size(); ++i) add_blade(i);
    add_hub();
    add_loops();
    for (const PointLoad& load : rotor_.loads)
      for_blades(load.blade, [&](std::size_t i) {
        const double x = load.position.value_or(rotor_.blades[i].length);
        add_load(i, x, load.frame, load.force, load.moment, false);
      });
    for (const DistributedLoad& load : rotor_.distributed_loads)
      for_blades(load.blade, [&](std::size_t i) { add_distributed(load, i); });
    for (const HubLoad& load : rotor_.hub_loads)
      scene_.loads.push_back({{-1, 0.0, in_space(load.position)},
                              std::string(name_of(load.frame)),
                              in_space(load.force),
                              Vector(0.0, 0.0, load.torque),
                              false});
    for (const Sensor& sensor : scenario_.sensors) add_sensor(sensor);
    return std::move(scene_);
  }

 private:
  static Vector in_space(const Position& v) { return {v.x(), v.y(), 0.0}; }
  Vector along(std::size_t i) const {
    const double azimuth = rotor_.blades[i].azimuth;
    return {std::cos(azimuth), std::sin(azimuth), 0.0};
  }
  Vector across(std::size_t i) const {
    const Vector x = along(i);
    return {-x.y(), x.x(), 0.0};
  }
  /// Returns the axis of a closure of a blade, which is in the frame of its place `to`.
  Vector find_axis(std::size_t i, const Loop& loop) const {
    if (loop.kind != LoopKind::prismatic) return Vector::UnitZ();
    const Vector rotation = loop.to.orientation.value_or(Vector::Zero());
    const Vector axis = space::exponential(rotation).axes * loop.axes[0];
    return (axis.x() * along(i) + axis.y() * across(i)).normalized();
  }
  Vector place(std::size_t i, double x) const { return (rotor_.hub.radius + x) * along(i); }

  void add_blade(std::size_t i) {
    const Blade& blade = rotor_.blades[i];
    scene_.subsystems.push_back("blade " + std::to_string(i + 1));
    for (int j = 0; j < blade.bodies; ++j) add_body(i, j);
    scene_.tips.push_back(static_cast<int>(scene_.nodes.size()) - 1);
  }
  void add_body(std::size_t i, int j) {
    const Blade& blade = rotor_.blades[i];
    const plane::BeamProperties body = plane::make_beam_properties(blade, j);
    Strip strip{scene_.subsystems.back() + " / body " + std::to_string(j + 1),
                static_cast<int>(i),
                static_cast<int>(scene_.nodes.size()),
                0,
                {}};
    std::vector<double> stations;
    for (const int k : shown_nodes(blade.elements, stride_)) {
      stations.push_back((j + static_cast<double>(k) / blade.elements) * body.length);
      scene_.nodes.push_back({0, place(i, stations.back()), spatial::Tensor::Identity()});
      scene_.sources.push_back({static_cast<int>(i), j, k});
    }
    strip.nodes = static_cast<int>(stations.size());
    strip.rings = make_rings(stations, strip.first, per_element_, [&](double x) {
      Ring ring;
      ring.at.p = place(i, x);
      ring.y = across(i);
      const double inner = std::clamp(x - j * body.length, 0.0, body.length);
      // The model does not know the size of the section across the plane: it is drawn round.
      ring.half_y = ring.half_z = 2.0 * std::sqrt(squared_gyration(body, inner));
      return ring;
    });
    scene_.strips.push_back(std::move(strip));
  }

  void add_hub() {
    const double radius = scene_.radius();
    const double hub = std::max(rotor_.hub.radius, 0.02 * radius);
    scene_.solids.push_back(
        make_cylinder(Vector::UnitZ(), hub, std::min(0.5 * hub, 0.03 * radius)));
    scene_.solids.back().name = "hub";
  }

  /// Returns the element of a blade at a place.
  Place find_place(std::size_t i, double x) const {
    const Blade& blade = rotor_.blades[i];
    const double body = blade.length / blade.bodies;
    for (const Strip& strip : scene_.strips) {
      if (strip.subsystem != static_cast<int>(i)) continue;
      for (int k = 0; k + 1 < strip.nodes; ++k) {
        const auto at = static_cast<std::size_t>(strip.first + k);
        const auto station = [&](std::size_t node) {
          return (scene_.sources[node].body +
                  static_cast<double>(scene_.sources[node].node) / blade.elements) *
                 body;
        };
        const double a = station(at), b = station(at + 1);
        if (x <= b * (1.0 + 1e-12)) return {static_cast<int>(at), (x - a) / (b - a), place(i, x)};
      }
    }
    return {scene_.tips[i], 0.0, place(i, x)};
  }

  /// Returns a place of a loop of a blade; on hub, mount and anchors it turns with the azimuth.
  Place find_end(std::size_t i, const LoopPlace& place) const {
    if (place.carrier == LoopPlace::Carrier::body)
      return find_place(i, place.station.value_or(rotor_.blades[i].length));
    int anchor = -1;
    for (std::size_t a = 0; a < rotor_.anchors.size(); ++a)
      if (rotor_.anchors[a].name == place.name) anchor = static_cast<int>(a);
    const Vector p = place.point.x() * along(i) + place.point.y() * across(i);
    return {-1, 0.0, p, find_group(scene_, place.carrier, anchor)};
  }
  void add_loops() {
    std::vector<const Loop*> loops;
    for (const Blade& blade : rotor_.blades)
      for (const Loop& loop : blade.loops) loops.push_back(&loop);
    add_carriers(rotor_.anchors, loops, scene_);
    for (std::size_t i = 0; i < rotor_.blades.size(); ++i)
      for (const Loop& loop : rotor_.blades[i].loops) {
        LoopMark mark;
        mark.name = scene_.subsystems[i] + " / " + loop.name;
        mark.kind = name_of(loop.kind);
        mark.subsystem = static_cast<int>(i);
        mark.from = find_end(i, loop.from);
        mark.to = find_end(i, loop.to);
        if (count_axes(loop.kind) == 1) mark.axes.push_back(find_axis(i, loop));
        mark.is_sprung = is_sprung(loop);
        scene_.loops.push_back(std::move(mark));
      }
    add_plates(rotor_.anchors, scene_);
  }

  template <class Visit>
  void for_blades(const BladeChoice& choice, Visit visit) const {
    for (std::size_t i = 0; i < rotor_.blades.size(); ++i)
      if (choice.holds(i)) visit(i);
  }

  void add_load(std::size_t i, double x, LoadFrame frame, const Position& force, double moment,
                bool is_distributed) {
    Vector v = in_space(force);
    // Forces that turn with the section are given in the axes of the blade.
    if (frame == LoadFrame::section) v = force.x() * along(i) + force.y() * across(i);
    scene_.loads.push_back({find_place(i, x), std::string(name_of(frame)), v,
                            Vector(0.0, 0.0, moment), is_distributed});
  }
  void add_distributed(const DistributedLoad& load, std::size_t i) {
    constexpr int kArrows = 9;
    const double to = load.to.value_or(rotor_.blades[i].length);
    for (int k = 0; k < kArrows; ++k)
      add_load(i, load.from + (to - load.from) * k / (kArrows - 1), load.frame,
               load.force_per_length, load.moment_per_length, true);
  }
  void add_sensor(const Sensor& sensor) {
    if (!has_position(sensor.quantity) && !sensor.joint) return;
    for_blades(sensor.blade, [&](std::size_t i) {
      const Blade& blade = rotor_.blades[i];
      double x = sensor.position.value_or(blade.length);
      if (sensor.joint) x = sensor.joint->body() * blade.length / blade.bodies;
      scene_.sensors.push_back(
          {sensor.name.empty() ? std::string(name_of(sensor.quantity)) : sensor.name,
           find_place(i, x)});
    });
  }

  const Scenario& scenario_;
  const Rotor& rotor_;
  std::size_t stride_ = 1;
  int per_element_ = 1;
  Scene scene_;
};

}  // namespace

Scene make_planar_scene(const Scenario& scenario, std::size_t most_nodes) {
  return PlanarScene(scenario, most_nodes).make();
}

}  // namespace spoke::scene
