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
  if (blade == kNextBlade)  // those of blades are numbers by now
    return {"blade",
            "is \"next\", but no blade comes before it; expected a whole number from 1 to " +
                std::to_string(last)};
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

/// Finds a fault of an end of a loop that is `owner`'s.
Fault find_end_fault(const LoopPlace& to, const Model& model, const TreeName& owner) {
  const bool is_blade = to.subsystem.empty();
  if (Fault fault = find_tree_fault({to.blade, to.subsystem}, model)) return fault;
  if (TreeName{to.blade, to.subsystem} == owner)
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

Fault find_ends_fault(const std::vector<Loop>& loops, const Model& model, const TreeName& owner) {
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (is_elsewhere(loops[k].to))
      if (Fault fault = find_end_fault(loops[k].to, model, owner))
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
  for (std::size_t i = 0; i < blades.size(); ++i) {
    for (Loop& loop : blades[i].loops)
      if (is_elsewhere(loop.to) && loop.to.blade == kNextBlade) loop.to.blade = next_of(i);
    for (Coupling& coupling : blades[i].couplings)
      for (CoupledJoint& at : coupling.joints)
        if (at.blade == kNextBlade) at.blade = next_of(i);
  }
}

Fault find_tree_fault(const TreeName& name, const Model& model) {
  if (name.blade != 0 && !name.subsystem.empty())
    return {"blade", "given along with subsystem, expected only one of them"};
  return name.subsystem.empty() ? find_blade_fault(name.blade, model)
                                : find_subsystem_fault(name.subsystem, model);
}

Fault find_anchor_body_fault(const Model& model) {
  for (std::size_t i = 0; i < model.anchors.size(); ++i) {
    const Anchor& anchor = model.anchors[i];
    if (anchor.frame != Anchor::Frame::body) continue;
    LoopPlace place;
    place.name = anchor.body;
    place.station = anchor.station;
    place.interface = anchor.interface;
    place.subsystem = anchor.subsystem.empty() ? std::string(kSupportName) : anchor.subsystem;
    const std::string key = "anchor." + std::to_string(i + 1);
    if (anchor.subsystem.empty() && !model.support)
      return {key + ".frame",
              "is \"" + anchor.body +
                  "\", expected \"mount\", \"hub\", \"axle\", or the name of a body "
                  "along with subsystem"};
    if (Fault fault = find_tree_fault({0, place.subsystem}, model)) return fault.within(key);
    LoopSurroundings around;
    for (const Subsystem& subsystem : model.subsystems)
      if (subsystem.name == place.subsystem) around = surroundings_of(subsystem, model);
    if (around.find(place) == nullptr) {
      std::vector<std::string_view> names;
      for (const LoopBody& body : around.bodies) names.push_back(body.name);
      return {key + ".frame", describe_unknown(anchor.body, names)};
    }
    if (Fault fault = find_fault(place, around)) return fault.within(key);
  }
  return {};
}

Fault find_loop_end_fault(const Model& model) {
  return find_in_trees(model, [&model](const auto& owner, const TreeName& name) {
    return find_ends_fault(owner.loops, model, name);
  });
}

}  // namespace spoke::spatial
