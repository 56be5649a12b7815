// Rules for subsystems: names that lead somewhere, and joints that make a tree.

#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

constexpr std::string_view kHub = "hub";

using Names = std::map<std::string_view, std::size_t>;  // indices of bodies by name

Fault find_body_faults(const Subsystem& subsystem, Names& names) {
  const FirstFault first;
  for (std::size_t i = 0; i < subsystem.bodies.size() && !first.found(); ++i) {
    const Body& body = subsystem.bodies[i];
    const std::string path = "body." + std::to_string(i + 1);
    first.add(find_name_fault(body.name).within(path));
    if (body.name == kHub)
      first.add({path + ".name", "is \"hub\", which is the hub's; expected another name"});
    if (!names.emplace(body.name, i).second)
      first.add({path + ".name",
                 "is \"" + body.name + "\" as another body's, expected a name of its own"});
    first.add(
        std::visit([](const auto& shape) { return find_fault(shape); }, body.shape).within(path));
  }
  return first.found();
}

std::vector<std::string_view> list(const Names& names, bool with_hub) {
  std::vector<std::string_view> all;
  if (with_hub) all.push_back(kHub);
  for (const auto& [name, index] : names) all.push_back(name);
  return all;
}

/// Finds a fault of the place on the parent that a joint names.
Fault find_place_fault(const SubsystemJoint& joint, const Subsystem& subsystem,
                       const Names& names) {
  const Body* parent = joint.parent == kHub ? nullptr : &subsystem.bodies[names.at(joint.parent)];
  const auto* solid = parent ? std::get_if<SolidBody>(&parent->shape) : nullptr;
  if (solid && joint.station)
    return {"station", "belongs to beams, expected interface on a parent that is a solid"};
  if (solid) return find_interface_fault(joint.interface, *solid);
  if (!joint.interface.empty())
    return {"interface", "would be ignored, expected only on a parent that is a solid"};
  if (!joint.station) return {};
  const auto* beam = parent ? std::get_if<Beam>(&parent->shape) : nullptr;
  if (beam == nullptr)
    return {"station", "would be ignored, expected only on a parent that is a beam: give offset"};
  const FirstFault first;
  first("station", *joint.station, {"m, from root to tip of the parent", 0.0, beam->length});
  return first.found();
}

Fault find_link_fault(const SubsystemJoint& joint, const Subsystem& subsystem, const Names& names) {
  if (joint.parent != kHub && !names.contains(joint.parent))
    return {"parent", describe_unknown(joint.parent, list(names, true))};
  if (!names.contains(joint.child))
    return {"child", describe_unknown(joint.child, list(names, false))};
  if (joint.child == joint.parent)
    return {"child", "is \"" + joint.child + "\", the parent; expected another body"};
  return find_place_fault(joint, subsystem, names);
}

/// Finds a body with two parents, with none, or in a circle, where the names of joints are fine.
Fault find_shape_fault(const Subsystem& subsystem, const Names& names) {
  // Joint whose child the body is.
  std::vector<std::ptrdiff_t> carrier(subsystem.bodies.size(), -1);
  for (std::size_t i = 0; i < subsystem.joints.size(); ++i) {
    std::ptrdiff_t& before = carrier[names.at(subsystem.joints[i].child)];
    if (before >= 0)
      return {"joint." + std::to_string(i + 1) + ".child",
              "is \"" + subsystem.joints[i].child + "\", the child of joint " +
                  std::to_string(before + 1) +
                  " already; expected a tree, closed by [[subsystem.loop]]"};
    before = static_cast<std::ptrdiff_t>(i);
  }
  for (std::size_t i = 0; i < carrier.size(); ++i)
    if (carrier[i] < 0)
      return {"body." + std::to_string(i + 1),
              "is no child of a joint, expected [[subsystem.joint]] "
              "with child = \"" +
                  subsystem.bodies[i].name + "\""};
  for (std::size_t i = 0; i < carrier.size(); ++i) {
    std::size_t steps = 0;
    for (std::string_view at = subsystem.bodies[i].name; at != kHub; ++steps) {
      if (steps > carrier.size())
        return {"joint." + std::to_string(carrier[i] + 1) + ".parent",
                "is \"" + subsystem.joints[static_cast<std::size_t>(carrier[i])].parent +
                    "\", which makes a circle of bodies, expected ways that lead to \"hub\""};
      at = subsystem.joints[static_cast<std::size_t>(carrier[names.at(at)])].parent;
    }
  }
  return {};
}

}  // namespace

Fault find_fault(const Subsystem& subsystem) {
  const FirstFault first;
  first.add(find_name_fault(subsystem.name));
  visit_fields(subsystem, first);
  if (subsystem.bodies.empty())
    first.add({"body", "is missing, expected tables headed [[subsystem.body]]"});
  Names names;
  if (!first.found()) first.add(find_body_faults(subsystem, names));
  std::set<std::string_view> joint_names;
  for (std::size_t i = 0; i < subsystem.joints.size() && !first.found(); ++i) {
    const SubsystemJoint& joint = subsystem.joints[i];
    const std::string path = "joint." + std::to_string(i + 1);
    first.add(find_link_fault(joint, subsystem, names).within(path));
    first.add(find_fault(joint.joint).within(path));
    if (!joint.joint.name.empty() && !joint_names.insert(joint.joint.name).second)
      first.add({path + ".name",
                 "is \"" + joint.joint.name + "\" as another joint's, expected a name of its own"});
  }
  if (!first.found()) first.add(find_shape_fault(subsystem, names));
  return first.found();
}

std::string find_size_fault(const Model& model) {
  constexpr std::int64_t most_elements = 20'000'000;
  std::int64_t elements = 0;
  const auto add = [&](const Beam& beam) { elements += std::int64_t{beam.bodies} * beam.elements; };
  for (const Blade& blade : model.blades) add(blade.beam);
  for (const Subsystem& subsystem : model.subsystems)
    for (const Body& body : subsystem.bodies)
      if (const auto* beam = std::get_if<Beam>(&body.shape)) add(*beam);
  if (elements <= most_elements) return {};
  return "makes " + std::to_string(elements) + " elements, expected at most " +
         std::to_string(most_elements);
}

}  // namespace spoke::spatial
