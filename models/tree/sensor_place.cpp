// Finds the trees and bodies that sensors name.

#include "models/tree/sensor_place.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <variant>

#include "models/tree/axle_carrier.h"

namespace spoke::spatial {
int SensorPlace::body_at(const Tree& of, double station) const {
  assert(!bodies.empty());
  const double resolution = 1e-9 * std::abs(station);
  const auto found = std::find_if(bodies.begin(), bodies.end() - 1, [&](int body) {
    const auto& part = std::get<FlexibleBody>(of.bodies[static_cast<std::size_t>(body)].shape);
    return station <= part.nodes.back() + resolution;
  });
  return *found;
}

std::vector<SensorPlace> find_places(const Sensor& sensor, std::size_t blades,
                                     const std::vector<Tree>& trees) {
  std::vector<SensorPlace> places;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const bool is_blade = i < blades;
    const bool is_there = sensor.subsystem.empty() ? is_blade && sensor.blade.holds(i)
                                                   : !is_blade && trees[i].name == sensor.subsystem;
    if (!is_there) continue;
    SensorPlace place{i};
    for (std::size_t j = 0; j < trees[i].bodies.size(); ++j)
      if (is_blade ? j <= find_tip_body(trees[i])
                   : sensor.body.empty() || is_part_of(trees[i].bodies[j], sensor.body))
        place.bodies.push_back(static_cast<int>(j));
    if (!place.bodies.empty()) places.push_back(std::move(place));
  }
  return places;
}

std::string sensor_name_of(const Tree& tree) {
  std::string name = tree.name;
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
}

std::vector<std::string> joint_columns_of(const Tree& tree) {
  std::vector<std::string> names;
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    const Joint& joint = tree.bodies[j].joint;
    const int count = count_coordinates(joint.kind);
    const std::string name = sensor_name_of(tree) + "." +
                             (joint.name.empty() ? "joint" + std::to_string(j + 1) : joint.name);
    for (int c = 0; c < count; ++c)
      names.push_back(count == 1 ? name : name + "." + std::to_string(c + 1));
  }
  return names;
}

}  // namespace spoke::spatial
