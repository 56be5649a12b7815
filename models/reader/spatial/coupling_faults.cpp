// Rules for couplings of joints.

#include "models/reader/spatial/coupling_faults.h"

#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "models/reader/keys/tree_keys.h"
#include "models/reader/spatial/loop_ends.h"
#include "models/support/nearest_name.h"
#include "models/tree/axle_carrier.h"

namespace spoke::spatial {
namespace {

Fault find_coordinate_fault(const CoupledJoint& at, const CouplingEnds& ends) {
  if (ends.empty()) return {"joint", "is \"" + at.joint + "\", but no joint there has a name"};
  const auto end = ends.find(at.joint);
  if (end == ends.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, joint] : ends) names.push_back(name);
    return {"joint", describe_unknown(at.joint, names)};
  }
  const JointKind kind = end->second.kind;
  const int count = count_coordinates(kind);
  if (count == 0 || kind == JointKind::spherical)
    return {"joint", "is \"" + at.joint + "\", of kind \"" + std::string(name_of(kind)) +
                         "\", expected one whose coordinates are angles about axes, or ways"};
  if (at.coordinate < 1 || at.coordinate > count)
    return {"coordinate", "is " + std::to_string(at.coordinate) + ", expected 1 to " +
                              std::to_string(count) + ", the coordinates of joint \"" + at.joint +
                              "\""};
  if (kind == JointKind::bushing &&
      !end->second.is_free[static_cast<std::size_t>(at.coordinate - 1)])
    return {"coordinate", "is " + std::to_string(at.coordinate) + ", which joint \"" + at.joint +
                              "\" holds, expected a direction in which the bushing moves"};
  if (!(std::isfinite(at.ratio) && at.ratio != 0.0))
    return {"ratio", "is " + describe(at.ratio) + ", expected a number other than 0"};
  return {};
}

/// `elsewhere`: by joint, those of the other blade or subsystem that it is on; empty: not known.
Fault find_one_fault(const Coupling& coupling, const CouplingEnds& ends,
                     const std::vector<CouplingEnds>& elsewhere) {
  const FirstFault first;
  first.add(find_name_fault(coupling.name));
  if (coupling.joints.size() < 2)
    first.add({"joints", "has " + std::to_string(coupling.joints.size()) +
                             " of the two or more coordinates that it is to couple"});
  std::set<std::tuple<int, std::string, std::string, int>> before;
  bool is_any_own = false, is_any_free = false;
  for (std::size_t i = 0; i < coupling.joints.size() && !first.found(); ++i) {
    const CoupledJoint& at = coupling.joints[i];
    const std::string path = "joints." + std::to_string(i + 1);
    if (!before.emplace(at.blade, at.subsystem, at.joint, at.coordinate).second)
      first.add({path + ".joint", "is the same coordinate as another one of the coupling"});
    const CouplingEnds* on = &ends;
    if (at.is_elsewhere()) {
      is_any_free |= elsewhere.empty();  // they are not known yet
      if (elsewhere.empty()) continue;
      on = &elsewhere[i];
    }
    is_any_own |= !at.is_elsewhere();
    first.add(find_coordinate_fault(at, *on).within(path));
    if (first.found()) break;
    is_any_free |= on->find(at.joint)->second.is_free[static_cast<std::size_t>(at.coordinate - 1)];
  }
  if (!first.found() && !is_any_own)
    first.add({"joints", "are all elsewhere, expected one of the blade or subsystem itself"});
  if (!first.found() && !is_any_free)
    first.add({"joints", "are all prescribed, expected one that is free"});
  find_range_faults("", keys::kCouplingRows, coupling, first);
  if (coupling.damping > 0.0 && coupling.stiffness == 0.0)
    first.add({"damping", "is given without stiffness, expected both or none"});
  return first.found();
}

void add(const Joint& joint, CouplingEnds& ends) {
  if (joint.name.empty()) return;
  CouplingEnd& end = ends[joint.name];
  end.kind = joint.kind;
  for (const JointCoordinate& coordinate : joint.coordinates)
    end.is_free.push_back(!coordinate.motion);
}

void add_axles(const std::vector<int>& rotors, const Model& model, CouplingEnds& ends) {
  for (const int r : rotors) {
    CouplingEnd& axle = ends[prefix_of_rotor(model, r) + "axle"];
    axle.kind = JointKind::revolute;
    axle.is_free = {!is_hub_prescribed(model, r)};
  }
}

}  // namespace

CouplingEnds ends_of(const Blade& blade, const std::vector<int>& rotors, const Model& model) {
  CouplingEnds ends;
  for (const BladeJoint& at : blade.joints) add(at.joint, ends);
  add_axles(rotors, model, ends);
  return ends;
}

CouplingEnds ends_of(const Subsystem& subsystem, const Model& model) {
  CouplingEnds ends;
  for (const SubsystemJoint& at : subsystem.joints) add(at.joint, ends);
  add_axles(find_rotors_on(model, subsystem.name), model, ends);
  return ends;
}

Fault find_fault(const std::vector<Coupling>& couplings, const CouplingEnds& ends) {
  const FirstFault first;
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < couplings.size() && !first.found(); ++i) {
    const std::string path = "coupling." + std::to_string(i + 1);
    first.add(find_one_fault(couplings[i], ends, {}).within(path));
    if (!names.insert(couplings[i].name).second)
      first.add({path + ".name", "is \"" + couplings[i].name +
                                     "\" as another coupling's, expected a name of its own"});
  }
  return first.found();
}

namespace {

CouplingEnds ends_on(const Blade& blade, const Model& model) {
  return ends_of(blade, find_rotors_on(model, blade), model);
}
CouplingEnds ends_on(const Subsystem& subsystem, const Model& model) {
  return ends_of(subsystem, model);
}

/// Finds the blade or subsystem, by its ends, that a joint names.
Fault find_elsewhere(const CoupledJoint& at, const Model& model, CouplingEnds& ends) {
  if (Fault fault = find_tree_fault({at.blade, at.subsystem}, model)) return fault;
  if (at.subsystem.empty()) {
    ends = ends_on(model.blades[static_cast<std::size_t>(at.blade) - 1], model);
    return {};
  }
  for (const Subsystem& subsystem : model.subsystems)
    if (subsystem.name == at.subsystem) ends = ends_of(subsystem, model);
  return {};
}

/// Finds a fault of couplings of `owner` whose joints are on several blades or subsystems. `own`:
/// the owner's joints.
Fault find_fault_across(const std::vector<Coupling>& couplings, const CouplingEnds& own,
                        const Model& model, const TreeName& owner) {
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    const std::string path = "coupling." + std::to_string(k + 1);
    const std::vector<CoupledJoint>& joints = couplings[k].joints;
    std::vector<CouplingEnds> elsewhere(joints.size());
    bool is_across = false;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (!joints[j].is_elsewhere()) continue;
      is_across = true;
      const std::string at = path + ".joints." + std::to_string(j + 1);
      if (Fault fault = find_elsewhere(joints[j], model, elsewhere[j])) return fault.within(at);
      if (TreeName{joints[j].blade, joints[j].subsystem} == owner)
        return Fault{joints[j].subsystem.empty() ? "blade" : "subsystem",
                     "is that of the coupling itself, expected none"}
            .within(at);
    }
    if (!is_across) continue;
    if (Fault fault = find_one_fault(couplings[k], own, elsewhere)) return fault.within(path);
  }
  return {};
}

}  // namespace

Fault find_coupling_across_fault(const Model& model) {
  return find_in_trees(model, [&model](const auto& owner, const TreeName& name) {
    return find_fault_across(owner.couplings, ends_on(owner, model), model, name);
  });
}

}  // namespace spoke::spatial
