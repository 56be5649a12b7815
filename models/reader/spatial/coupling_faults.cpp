// Rules for couplings of joints.

#include "models/reader/spatial/coupling_faults.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "models/reader/keys/tree_keys.h"
#include "models/support/nearest_name.h"

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
  if (count == 0 || kind == JointKind::spherical || kind == JointKind::bushing)
    return {"joint", "is \"" + at.joint + "\", of kind \"" + std::string(name_of(kind)) +
                         "\", expected one whose coordinates are angles about axes, or ways"};
  if (at.coordinate < 1 || at.coordinate > count)
    return {"coordinate", "is " + std::to_string(at.coordinate) + ", expected 1 to " +
                              std::to_string(count) + ", the coordinates of joint \"" + at.joint +
                              "\""};
  if (!(std::isfinite(at.ratio) && at.ratio != 0.0))
    return {"ratio", "is " + describe(at.ratio) + ", expected a number other than 0"};
  return {};
}

Fault find_one_fault(const Coupling& coupling, const CouplingEnds& ends) {
  const FirstFault first;
  first.add(find_name_fault(coupling.name));
  if (coupling.joints.size() < 2)
    first.add({"joints", "has " + std::to_string(coupling.joints.size()) +
                             " of the two or more coordinates that it is to couple"});
  std::set<std::pair<std::string, int>> before;
  bool is_any_free = false;
  for (std::size_t i = 0; i < coupling.joints.size() && !first.found(); ++i) {
    const CoupledJoint& at = coupling.joints[i];
    const std::string path = "joints." + std::to_string(i + 1);
    first.add(find_coordinate_fault(at, ends).within(path));
    if (first.found()) break;
    if (!before.emplace(at.joint, at.coordinate).second)
      first.add({path + ".joint", "is the same coordinate as another one of the coupling"});
    is_any_free |= ends.find(at.joint)->second.is_free[static_cast<std::size_t>(at.coordinate - 1)];
  }
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

}  // namespace

CouplingEnds ends_of(const Blade& blade) {
  CouplingEnds ends;
  for (const BladeJoint& at : blade.joints) add(at.joint, ends);
  return ends;
}

CouplingEnds ends_of(const Subsystem& subsystem, const Model& model) {
  CouplingEnds ends;
  for (const SubsystemJoint& at : subsystem.joints) add(at.joint, ends);
  for (const int r : find_rotors_on(model, subsystem.name)) {
    CouplingEnd& axle = ends[prefix_of_rotor(model, r) + "axle"];
    axle.kind = JointKind::revolute;
    axle.is_free = {!is_hub_prescribed(model, r)};
  }
  return ends;
}

Fault find_fault(const std::vector<Coupling>& couplings, const CouplingEnds& ends) {
  const FirstFault first;
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < couplings.size() && !first.found(); ++i) {
    const std::string path = "coupling." + std::to_string(i + 1);
    first.add(find_one_fault(couplings[i], ends).within(path));
    if (!names.insert(couplings[i].name).second)
      first.add({path + ".name", "is \"" + couplings[i].name +
                                     "\" as another coupling's, expected a name of its own"});
  }
  return first.found();
}

}  // namespace spoke::spatial
