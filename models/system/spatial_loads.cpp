// Finds the bodies, elements and points that loads in space act at.

#include "models/system/spatial_loads.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <variant>

#include "models/support/gauss_rule.h"

namespace spoke {
namespace {

using spatial::FlexibleBody;
using Point = BodyLoad<Space>::Point;
using LoadsByBody = std::vector<std::vector<BodyLoad<Space>>>;

/// Whether a load is on a tree, and on which of its bodies.
class Target {
 public:
  Target(const spatial::Model& model, const spatial::LoadPlace& place, std::size_t tree)
      : place_(place) {
    const bool is_blade = tree < model.blades.size();
    if (place.subsystem.empty()) {
      is_there_ = is_blade && place.blade.holds(tree);
    } else {
      is_there_ = !is_blade && model.subsystems[tree - model.blades.size()].name == place.subsystem;
    }
  }
  bool is_there() const { return is_there_; }
  /// Whether a load is on a body; all bodies into which a beam is cut have the beam's name.
  bool holds(const spatial::TreeBody& body) const {
    if (place_.subsystem.empty()) return std::holds_alternative<FlexibleBody>(body.shape);
    return body.name == place_.body || body.name.starts_with(place_.body + " / body ");
  }

 private:
  const spatial::LoadPlace& place_;
  bool is_there_ = false;
};

template <class Load>
std::shared_ptr<LoadCourse> course_of(const Load& load) {
  return std::make_shared<LoadCourse>(LoadCourse{load.factor, load.ramp, load.name});
}

/// Returns the element of a body that holds a station of its beam.
std::size_t element_at(const FlexibleBody& body, double station) {
  assert(body.nodes.size() > 1);
  const auto after = std::upper_bound(body.nodes.begin() + 1, body.nodes.end() - 1, station);
  return static_cast<std::size_t>(after - body.nodes.begin()) - 1;
}

Point point_at(const FlexibleBody& body, std::size_t element, double station, double weight) {
  assert(element + 1 < body.nodes.size());
  const double begin = body.nodes[element], end = body.nodes[element + 1];
  return {static_cast<int>(element), (station - begin) / (end - begin), weight};
}

double end_of(const spatial::Tree& tree, const FlexibleBody& body) {
  return tree.beams[body.beam].length;
}

/// Whether a body carries a load at a station; between two bodies, the inner one does.
bool carries(const FlexibleBody& body, double station) {
  const bool is_first = body.nodes.front() == 0.0;
  return station <= body.nodes.back() &&
         (station > body.nodes.front() || (is_first && station == 0.0));
}

/// Returns a load on a solid. Traction becomes the force that it makes.
BodyLoad<Space> make_solid_load(const spatial::PointLoad& load, const spatial::SolidPart& part) {
  BodyLoad<Space> made{{}, load.frame, load.force, load.moment, course_of(load)};
  if (load.traction)
    made.force =
        *load.traction *
        solid::choose_nodes(*part.geometry().mesh, *find_loaded_set(load, part.body())).area;
  Point& point = made.points.emplace_back();
  point.element = static_cast<int>(find_loaded_place(load, part));
  return made;
}

void add_point_load(const spatial::PointLoad& load, const spatial::Tree& tree, const Target& target,
                    LoadsByBody& loads) {
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    if (!target.holds(tree.bodies[j])) continue;
    if (const auto* solid = std::get_if<spatial::SolidPart>(&tree.bodies[j].shape)) {
      loads[j].push_back(make_solid_load(load, *solid));
      continue;
    }
    BodyLoad<Space> made{{}, load.frame, load.force, load.moment, course_of(load)};
    if (const auto* body = std::get_if<FlexibleBody>(&tree.bodies[j].shape)) {
      const double station = load.position.value_or(end_of(tree, *body));
      if (!carries(*body, station)) continue;
      made.points.push_back(point_at(*body, element_at(*body, station), station, 1.0));
    } else {
      made.points.push_back({0, 0.0, 1.0, load.point});
    }
    loads[j].push_back(std::move(made));
  }
}

void add_distributed_load(const spatial::DistributedLoad& load, const spatial::Tree& tree,
                          const Target& target, LoadsByBody& loads) {
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    const auto* body = std::get_if<FlexibleBody>(&tree.bodies[j].shape);
    if (!body || !target.holds(tree.bodies[j])) continue;
    BodyLoad<Space> made{
        {}, load.frame, load.force_per_length, load.moment_per_length, course_of(load)};
    const double to = load.to.value_or(end_of(tree, *body));
    for (std::size_t e = 0; e + 1 < body->nodes.size(); ++e) {
      const double begin = std::max(body->nodes[e], load.from);
      const double length = std::min(body->nodes[e + 1], to) - begin;
      if (length <= 0.0) continue;
      const double from = point_at(*body, e, begin, 0.0).s;
      const double end = point_at(*body, e, begin + length, 0.0).s;
      for (std::size_t k = 0; k < GaussRule<4>::kPoints; ++k) {
        Point& point = made.points.emplace_back(point_at(
            *body, e, begin + GaussRule<4>::places[k] * length, GaussRule<4>::weights[k] * length));
        point.begin = from;
        point.end = end;
        point.length = length;
      }
    }
    if (!made.points.empty()) loads[j].push_back(std::move(made));
  }
}

}  // namespace

std::vector<std::vector<BodyLoad<Space>>> make_body_loads(const spatial::Model& model,
                                                          const spatial::Tree& tree,
                                                          std::size_t index) {
  assert(index < model.blades.size() + model.subsystems.size());
  LoadsByBody loads(tree.bodies.size());
  for (const spatial::PointLoad& load : model.loads) {
    const Target target(model, load.place, index);
    if (target.is_there()) add_point_load(load, tree, target, loads);
  }
  for (const spatial::DistributedLoad& load : model.distributed_loads) {
    const Target target(model, load.place, index);
    if (target.is_there()) add_distributed_load(load, tree, target, loads);
  }
  return loads;
}

BodyLoad<Space> take_outboard(const BodyLoad<Space>& load, double along) {
  assert(along >= 0.0);
  constexpr double kSlack = 1e-9;
  BodyLoad<Space> taken = load;
  taken.points.clear();
  for (std::size_t k = 0; k < load.points.size(); ++k) {
    Point point = load.points[k];
    if (point.length == 0.0) {
      if (point.element + point.s >= along - kSlack) taken.points.push_back(point);
      continue;
    }
    // The place parts this stretch: the rule's points are put on the rest of it.
    const double cut = std::max(point.begin, along - point.element);
    if (cut >= point.end - kSlack) continue;
    const std::size_t of_rule = k % GaussRule<4>::kPoints;
    const double share = (point.end - cut) / (point.end - point.begin);
    point.s = cut + GaussRule<4>::places[of_rule] * (point.end - cut);
    point.weight *= share;
    taken.points.push_back(point);
  }
  return taken;
}

}  // namespace spoke
