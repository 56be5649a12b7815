// In the plane by number, in space by the scenario.

#include "engine/steady/tree_names.h"

#include "models/tree/sensor_place.h"

namespace spoke {
namespace {

TreeNames name_blade(const Blade& blade, std::size_t index) {
  const std::string number = std::to_string(index + 1);
  TreeNames names{"blade " + number, {}, {}, "blade" + number, blade.azimuth};
  for (int j = 0; j < blade.bodies; ++j) {
    names.bodies.push_back("body " + std::to_string(j + 1));
    names.joints.emplace_back();
  }
  return names;
}

TreeNames name_tree(const spatial::Tree& tree) {
  TreeNames names{tree.name, {}, {}, sensor_name_of(tree), tree.azimuth};
  for (const spatial::TreeBody& body : tree.bodies) {
    names.bodies.push_back(body.name);
    names.joints.push_back(body.joint.name.empty() ? "joint of " + body.name : body.joint.name);
  }
  return names;
}

}  // namespace

std::vector<TreeNames> name_trees(const Rotor& rotor) {
  std::vector<TreeNames> names;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i)
    names.push_back(name_blade(rotor.blades[i], i));
  return names;
}

std::vector<TreeNames> name_trees(const std::vector<spatial::Tree>& trees) {
  std::vector<TreeNames> names;
  for (const spatial::Tree& tree : trees) names.push_back(name_tree(tree));
  return names;
}

}  // namespace spoke
