// Names subsystems by number in the plane, by the scenario in space.

#include "engine/small_motions/steady/subsystem_names.h"

#include <cstdlib>

#include "models/tree/sensor_place.h"

namespace spoke {
namespace {

SubsystemNames name_blade(const Blade& blade, std::size_t index) {
  const std::string number = std::to_string(index + 1);
  SubsystemNames names{"blade " + number, {}, {}, "blade" + number, blade.azimuth};
  for (int j = 0; j < blade.bodies; ++j) {
    names.bodies.push_back("body " + std::to_string(j + 1));
    names.joints.emplace_back();
  }
  return names;
}

SubsystemNames name_subsystem(const spatial::Tree& tree) {
  SubsystemNames names{tree.name, {}, {}, sensor_name_of(tree), tree.azimuth};
  for (const spatial::TreeBody& body : tree.bodies) {
    names.bodies.push_back(body.name);
    names.joints.push_back(body.joint.name.empty() ? "joint of " + body.name : body.joint.name);
  }
  return names;
}

/// Returns the number of a blade by its name; 0: it is none.
int number_of_blade(const std::string& name) {
  const std::string word = "blade ";
  return name.starts_with(word) ? std::atoi(name.c_str() + word.size()) : 0;
}

}  // namespace

std::string join_names(const std::vector<std::string>& names) {
  bool is_row = names.size() > 1;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const int number = number_of_blade(names[k]);
    is_row = is_row && number > 0 && (k == 0 || number == number_of_blade(names[k - 1]) + 1);
  }
  if (is_row)
    return "blades " + std::to_string(number_of_blade(names.front())) + " to " +
           std::to_string(number_of_blade(names.back()));
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::vector<SubsystemNames> name_subsystems(const Rotor& rotor) {
  std::vector<SubsystemNames> names;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i)
    names.push_back(name_blade(rotor.blades[i], i));
  return names;
}

std::vector<SubsystemNames> name_subsystems(const std::vector<spatial::Tree>& trees) {
  std::vector<SubsystemNames> names;
  for (const spatial::Tree& tree : trees) names.push_back(name_subsystem(tree));
  return names;
}

}  // namespace spoke
