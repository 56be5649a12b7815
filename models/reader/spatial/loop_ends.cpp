// Goes through the loops of all blades and subsystems.

#include "models/reader/spatial/loop_ends.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/loop_faults.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

bool is_elsewhere(const LoopPlace& place) { return place.carrier == LoopPlace::Carrier::elsewhere; }

Fault find_blade_fault(int blade, const Model& model) {
  const auto last = static_cast<int>(model.blades.size());
  if (last == 0) return {"blade", "is given, but there are no blades"};
  if (blade >= 1 && blade <= last) return {};
  return {"blade", "is " + std::to_string(blade) + ", expected a whole number from 1 to " +
                       std::to_string(last) + ", or \"next\""};
}

Fault find_subsystem_fault(const std::string& subsystem, const Model& model) {
  std::vector<std::string_view> names;
  for (const Subsystem& own : model.subsystems) names.push_back(own.name);
  if (names.empty())
    return {"subsystem", "is \"" + subsystem + "\", but there is no [[subsystem]]"};
  if (std::find(names.begin(), names.end(), subsystem) == names.end())
    return {"subsystem", describe_unknown(subsystem, names)};
  return {};
}

/// Finds a body that the subsystem has not.
Fault find_body_fault(const LoopPlace& place, const LoopSurroundings& around) {
  if (around.is_blade() || around.find(place) != nullptr) return {};
  std::vector<std::string_view> names;
  for (const LoopBody& body : around.bodies) names.push_back(body.name);
  if (names.empty()) return {"subsystem", "has no bodies to end on, expected another one"};
  if (place.name.empty()) return {"body", "is missing, expected the name of one of the subsystem"};
  return {"body", describe_unknown(place.name, names)};
}

/// Finds a point on a beam that does not say from where.
Fault find_point_fault(const LoopPlace& place, const LoopSurroundings& around) {
  const LoopBody* body = around.find(place);
  if (body == nullptr || !body->length || place.station || place.point.isZero(0.0)) return {};
  return {"point", "is on a beam, expected station along with it, from whose axis it is"};
}

/// Finds a fault of an end; `own`: whether that is on the blade or subsystem itself.
template <class IsOwn>
Fault find_end_fault(const LoopPlace& to, const Model& model, const IsOwn& is_own) {
  const bool is_blade = to.subsystem.empty();
  if (Fault fault = find_tree_fault(to.blade, to.subsystem, model)) return fault;
  if (is_own(to))
    return {is_blade ? "blade" : "subsystem", "is that of the loop itself, expected none"};
  LoopSurroundings around;
  if (is_blade)
    around = surroundings_of(model.blades[static_cast<std::size_t>(to.blade) - 1], model);
  for (const Subsystem& subsystem : model.subsystems)
    if (subsystem.name == to.subsystem) around = surroundings_of(subsystem, model);
  LoopPlace there = to;
  there.carrier = LoopPlace::Carrier::body;
  if (Fault fault = find_body_fault(there, around)) return fault;
  if (Fault fault = find_fault(there, around)) return fault;
  return find_point_fault(there, around);
}

template <class IsOwn>
Fault find_ends_fault(const std::vector<Loop>& loops, const Model& model, const IsOwn& is_own) {
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (is_elsewhere(loops[k].to))
      if (Fault fault = find_end_fault(loops[k].to, model, is_own))
        return fault.within("to").within("loop." + std::to_string(k + 1));
  return {};
}

}  // namespace

void resolve_next_blades(Model& model) {
  std::vector<Blade>& blades = model.blades;
  const auto next_of = [&blades](std::size_t i) {
    std::size_t next = i;
    do {
      next = (next + 1) % blades.size();
    } while (blades[next].rotor != blades[i].rotor);
    return static_cast<int>(next) + 1;
  };
  for (std::size_t i = 0; i < blades.size(); ++i)
    for (Loop& loop : blades[i].loops)
      if (is_elsewhere(loop.to) && loop.to.blade == kNextBlade) loop.to.blade = next_of(i);
  for (std::size_t i = 0; i < blades.size(); ++i)
    for (Coupling& coupling : blades[i].couplings)
      for (CoupledJoint& at : coupling.joints)
        if (at.blade == kNextBlade) at.blade = next_of(i);
}

Fault find_tree_fault(int blade, const std::string& subsystem, const Model& model) {
  if (blade != 0 && !subsystem.empty())
    return {"blade", "given along with subsystem, expected only one of them"};
  return subsystem.empty() ? find_blade_fault(blade, model)
                           : find_subsystem_fault(subsystem, model);
}

Fault find_loop_end_fault(const Model& model) {
  for (std::size_t i = 0; i < model.blades.size(); ++i) {
    const auto is_own = [i](const LoopPlace& to) {
      return to.subsystem.empty() && to.blade == static_cast<int>(i) + 1;
    };
    if (Fault fault = find_ends_fault(model.blades[i].loops, model, is_own))
      return fault.within("blades." + std::to_string(i + 1));
  }
  for (std::size_t i = 0; i < model.subsystems.size(); ++i) {
    const Subsystem& subsystem = model.subsystems[i];
    const auto is_own = [&](const LoopPlace& to) { return to.subsystem == subsystem.name; };
    if (Fault fault = find_ends_fault(subsystem.loops, model, is_own))
      return fault.within(key_of_subsystem(model, i));
  }
  return {};
}

}  // namespace spoke::spatial
