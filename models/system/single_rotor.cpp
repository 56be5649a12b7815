// Filters what a rotor carries, and counts its blades anew.

#include "models/system/single_rotor.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <string_view>

#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

/// Returns a choice of blades among those of a rotor; none if it has none of them.
std::optional<BladeChoice> choose_among(const BladeChoice& blades, const spatial::Model& model,
                                        int rotor) {
  const auto is_own = [rotor](const spatial::Blade& blade) { return blade.rotor == rotor; };
  const auto begin = model.blades.begin();
  if (blades.is_all()) {
    if (std::any_of(begin, model.blades.end(), is_own)) return blades;
    return std::nullopt;
  }
  const auto chosen = begin + (blades.number() - 1);
  if (!is_own(*chosen)) return std::nullopt;
  return BladeChoice::number(static_cast<int>(std::count_if(begin, chosen, is_own)) + 1);
}

/// Whether a rotor carries the subsystem of a name, which is no support.
bool carries(const spatial::Model& model, int rotor, const std::string& name) {
  return std::any_of(model.subsystems.begin(), model.subsystems.end() - 1,
                     [&](const spatial::Subsystem& subsystem) {
                       return subsystem.name == name && subsystem.rotor == rotor;
                     });
}

/// Keeps the loads that are on a rotor.
template <class Load>
void keep_loads(const spatial::Model& model, int rotor, std::vector<Load>& loads) {
  std::vector<Load> kept;
  for (Load& load : loads) {
    if (load.place.subsystem.empty()) {
      const std::optional<BladeChoice> own = choose_among(load.place.blade, model, rotor);
      if (!own) continue;
      load.place.blade = *own;
    } else if (!carries(model, rotor, load.place.subsystem)) {
      continue;
    }
    kept.push_back(std::move(load));
  }
  loads = std::move(kept);
}

}  // namespace

int find_rotor(const spatial::Model& model, const std::string& name, const std::string& what) {
  std::vector<std::string_view> names;
  for (int r = 0; r < count_rotors(model) && !hub_of(model, r).name.empty(); ++r) {
    names.push_back(hub_of(model, r).name);
    if (names.back() == name) return r;
  }
  if (names.empty())
    throw InputError(what + " is \"" + name + "\", expected no name: there is no [[rotor]]");
  throw InputError(what + ' ' + describe_unknown(name, names));
}

spatial::Model without_support(const spatial::Model& model, int rotor) {
  assert(model.support && is_support(model, model.subsystems.back()));
  spatial::Model taken = model;
  taken.support.reset();
  taken.subsystems.pop_back();
  taken.hub = hub_of(model, rotor);
  taken.hub.mount = {};
  taken.rotors.clear();
  const auto is_other = [rotor](const auto& part) { return part.rotor != rotor; };
  std::erase_if(taken.blades, is_other);
  std::erase_if(taken.subsystems, is_other);
  std::erase_if(taken.hub_loads, is_other);
  for (spatial::Blade& blade : taken.blades) blade.rotor = 0;
  for (spatial::Subsystem& subsystem : taken.subsystems) subsystem.rotor = 0;
  for (spatial::HubLoad& load : taken.hub_loads) load.rotor = 0;
  for (Anchor& anchor : taken.anchors) anchor.rotor = 0;  // those of others carry none of its loops
  keep_loads(model, rotor, taken.loads);
  keep_loads(model, rotor, taken.distributed_loads);
  return taken;
}

std::vector<std::size_t> list_trees(const std::vector<spatial::Tree>& trees, int rotor) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i + 1 < trees.size(); ++i)  // the last is the support
    if (trees[i].rotor == rotor) numbers.push_back(i);
  return numbers;
}

std::vector<spatial::Tree> take_trees(const std::vector<spatial::Tree>& trees, int rotor) {
  const std::vector<std::size_t> numbers = list_trees(trees, rotor);
  std::vector<spatial::Tree> taken;
  for (const std::size_t i : numbers) {
    spatial::Tree& tree = taken.emplace_back(trees[i]);
    tree.rotor = 0;  // as in the model of this rotor alone
    for (spatial::LoopEnd& end : tree.ends) {
      const auto own = std::lower_bound(numbers.begin(), numbers.end(), end.tree);
      assert(own != numbers.end() && *own == end.tree);
      end.tree = static_cast<std::size_t>(own - numbers.begin());
    }
  }
  return taken;
}

std::vector<Sensor> take_sensors(const std::vector<Sensor>& sensors, const spatial::Model& model,
                                 int rotor) {
  std::vector<Sensor> taken;
  for (Sensor sensor : sensors) {
    if (!sensor.subsystem.empty()) {
      if (carries(model, rotor, sensor.subsystem)) taken.push_back(sensor);
      continue;
    }
    if (!is_of_blade(sensor.quantity)) {
      if (rotor == 0) taken.push_back(sensor);
      continue;
    }
    const std::optional<BladeChoice> own = choose_among(sensor.blade, model, rotor);
    if (!own) continue;
    sensor.blade = *own;
    taken.push_back(std::move(sensor));
  }
  return taken;
}

}  // namespace spoke
