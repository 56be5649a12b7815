// Integrates over stretches of beams.

#include "models/system/make_drag.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace spoke {
namespace {

/// Returns a value at a station, linear between those that are given.
double interpolate(const std::vector<double>& station, const std::vector<double>& values,
                   double at) {
  const auto next = std::upper_bound(station.begin() + 1, station.end() - 1, at);
  const auto k = static_cast<std::size_t>(next - station.begin());
  const double share = (at - station[k - 1]) / (station[k] - station[k - 1]);
  return (1.0 - share) * values[k - 1] + share * values[k];
}

/// Returns the nodes of a part of a beam and the stations of its drag within it, ascending [m].
std::vector<double> list_ends(const spatial::BodyDrag& drag, const std::vector<double>& nodes) {
  std::vector<double> ends = nodes;
  for (const double station : drag.station)
    if (station > nodes.front() && station < nodes.back()) ends.push_back(station);
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// Adds the drag of a part of a beam. `nodes`: their stations on the beam [m].
void add_part(const spatial::BodyDrag& drag, int body, const std::vector<double>& nodes,
              double begin, DragModel& made) {
  const std::vector<double> ends = list_ends(drag, nodes);
  const double resolution = 1e-12 * drag.station.back();
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double from = std::max(ends[k - 1], drag.station.front());
    const double to = std::min(ends[k], drag.station.back());
    if (to - from <= resolution) continue;
    for (const double side : {-1.0, 1.0}) {
      const double at = 0.5 * (from + to) + side * 0.5 * (to - from) / std::sqrt(3.0);
      const double across = interpolate(drag.station, drag.diameter, at) *
                            interpolate(drag.station, drag.coefficient, at);
      made.stretches.push_back({body, at - begin, 0.5 * (to - from) * across});
    }
  }
}

/// Adds a part of a beam to the axis of a tower, as far as it has a diameter. `last`: the station
/// of its last point, which the next part begins with.
void add_axis(const spatial::BodyDrag& drag, int body, const std::vector<double>& nodes,
              double begin, double& last, DragModel::Tower& tower) {
  const double resolution = 1e-12 * drag.station.back();
  for (const double at : list_ends(drag, nodes)) {
    if (at < drag.station.front() || at > drag.station.back()) continue;
    if (!tower.points.empty() && at - last <= resolution) continue;
    last = at;
    tower.points.push_back({body, at - begin, interpolate(drag.station, drag.diameter, at),
                            interpolate(drag.station, drag.coefficient, at)});
  }
}

bool disturbs(const spatial::BodyDrag& drag) {
  return drag.potential != spatial::TowerPotential::none ||
         drag.shadow != spatial::TowerShadow::none;
}

}  // namespace

std::shared_ptr<const DragModel> make_drag(const std::vector<spatial::Body>& described,
                                           const spatial::Tree& tree, const Subsystem<Space>& made,
                                           double density) {
  DragModel model;
  model.density = density;
  for (const spatial::Body& body : described) {
    if (!body.drag) continue;
    DragModel::Tower tower{body.drag->potential, body.drag->shadow, {}};
    double last = 0.0;
    for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
      const spatial::TreeBody& own = tree.bodies[j];
      if (own.is_hub() || own.is_generator() || !is_part_of(own, body.name)) continue;
      const int index = static_cast<int>(j);
      if (const auto* part = std::get_if<spatial::FlexibleBody>(&own.shape)) {
        add_part(*body.drag, index, part->nodes, made.bodies[j].begin, model);
        add_axis(*body.drag, index, part->nodes, made.bodies[j].begin, last, tower);
      } else {
        model.blocks.push_back(
            {index, space::Position(body.drag->point), space::Position(body.drag->area)});
      }
    }
    if (disturbs(*body.drag) && tower.points.size() > 1) model.towers.push_back(std::move(tower));
  }
  if (model.stretches.empty() && model.blocks.empty()) return nullptr;
  return std::make_shared<const DragModel>(std::move(model));
}

}  // namespace spoke
