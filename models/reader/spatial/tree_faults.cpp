// Rules for subsystems: names that lead somewhere, and joints that make a tree.

#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "models/reader/spatial/drag_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/support/nearest_name.h"
#include "models/tree/space_beam.h"

namespace spoke::spatial {
namespace {

using Names = std::map<std::string_view, std::size_t>;  // indices of bodies by name

Fault find_body_faults(const Subsystem& subsystem, const TreeBase& base, Names& names) {
  const FirstFault first;
  for (std::size_t i = 0; i < subsystem.bodies.size() && !first.found(); ++i) {
    const Body& body = subsystem.bodies[i];
    const std::string path = "body." + std::to_string(i + 1);
    first.add(find_name_fault(body.name).within(path));
    if (body.name == "hub")
      first.add({path + ".name", "is \"hub\", which is the hub's; expected another name"});
    if (body.name == base.name)
      first.add({path + ".name", "is \"" + body.name +
                                     "\", which is what the support stands on; expected another "
                                     "name"});
    if (!names.emplace(body.name, i).second)
      first.add({path + ".name",
                 "is \"" + body.name + "\" as another body's, expected a name of its own"});
    first.add(
        std::visit([](const auto& shape) { return find_fault(shape); }, body.shape).within(path));
    first.add(find_drag_fault(body).within("drag").within(path));
  }
  return first.found();
}

/// Returns the names of bodies after that of the base, if it is given.
std::vector<std::string_view> list(const Names& names, std::string_view base) {
  std::vector<std::string_view> all;
  if (!base.empty()) all.push_back(base);
  for (const auto& [name, index] : names) all.push_back(name);
  return all;
}

Fault find_link_fault(const SubsystemJoint& joint, const Subsystem& subsystem, const TreeBase& base,
                      const Names& names) {
  if (joint.parent != base.name && !names.contains(joint.parent))
    return {"parent", describe_unknown(joint.parent, list(names, base.name))};
  if (!names.contains(joint.child))
    return {"child", describe_unknown(joint.child, list(names, {}))};
  if (joint.child == joint.parent)
    return {"child", "is \"" + joint.child + "\", the parent; expected another body"};
  const bool is_on_base = joint.parent == base.name;
  return find_place_fault(is_on_base ? nullptr : &subsystem.bodies[names.at(joint.parent)],
                          joint.station, joint.interface);
}

/// Finds a joint that moves a beam whose axis begins beside the joint: no body is between the two.
Fault find_axis_fault(const SubsystemJoint& joint, const Body& child) {
  const auto* beam = std::get_if<Beam>(&child.shape);
  if (beam == nullptr || joint.joint.kind == JointKind::fixed) return {};
  const Vector begin = find_axis_begin(beam->sections);
  if (begin.isZero(0.0)) return {};
  return {"kind", "is \"" + std::string(name_of(joint.joint.kind)) + "\", but the axis of \"" +
                      child.name + "\" begins beside the joint, at sweep = " + describe(begin.y()) +
                      " and prebend = " + describe(begin.z()) +
                      "; expected \"fixed\", or a beam whose sweep and prebend are 0 at its root"};
}

/// Finds a body with two parents, with none, or in a circle, where the names of joints are fine.
Fault find_shape_fault(const Subsystem& subsystem, const TreeBase& base, const Names& names) {
  const std::string table = "[[" + std::string(base.table);
  // Joint whose child the body is.
  std::vector<std::ptrdiff_t> carrier(subsystem.bodies.size(), -1);
  for (std::size_t i = 0; i < subsystem.joints.size(); ++i) {
    std::ptrdiff_t& before = carrier[names.at(subsystem.joints[i].child)];
    if (before >= 0)
      return {"joint." + std::to_string(i + 1) + ".child",
              "is \"" + subsystem.joints[i].child + "\", the child of joint " +
                  std::to_string(before + 1) + " already; expected a tree, closed by " + table +
                  ".loop]]"};
    before = static_cast<std::ptrdiff_t>(i);
  }
  for (std::size_t i = 0; i < carrier.size(); ++i)
    if (carrier[i] < 0)
      return {"body." + std::to_string(i + 1), "is no child of a joint, expected " + table +
                                                   ".joint]] with child = \"" +
                                                   subsystem.bodies[i].name + "\""};
  for (std::size_t i = 0; i < carrier.size(); ++i) {
    std::size_t steps = 0;
    for (std::string_view at = subsystem.bodies[i].name; at != base.name; ++steps) {
      if (steps > carrier.size())
        return {"joint." + std::to_string(carrier[i] + 1) + ".parent",
                "is \"" + subsystem.joints[static_cast<std::size_t>(carrier[i])].parent +
                    "\", which makes a circle of bodies, expected ways that lead to \"" +
                    std::string(base.name) + '"'};
      at = subsystem.joints[static_cast<std::size_t>(carrier[names.at(at)])].parent;
    }
  }
  return {};
}

}  // namespace

Fault find_place_fault(const Body* carrier, const std::optional<double>& station,
                       const std::string& interface) {
  const auto* solid = carrier ? std::get_if<SolidBody>(&carrier->shape) : nullptr;
  if (solid && station)
    return {"station", "belongs to beams, expected interface on a parent that is a solid"};
  if (solid) return find_interface_fault(interface, *solid);
  if (!interface.empty())
    return {"interface", "would be ignored, expected only on a parent that is a solid"};
  if (!station) return {};
  const auto* beam = carrier ? std::get_if<Beam>(&carrier->shape) : nullptr;
  if (beam == nullptr)
    return {"station", "would be ignored, expected only on a parent that is a beam: give offset"};
  const FirstFault first;
  first("station", *station, {"m, from root to tip of the parent", 0.0, beam->length});
  return first.found();
}

TreeBase base_of(const Subsystem& subsystem, const Model& model) {
  if (!model.support || subsystem.name != kSupportName) return {};
  const SupportBase from = model.support->from;
  return {base_name(from), kSupportName, true, from == SupportBase::free};
}

Fault find_fault(const Subsystem& subsystem, const TreeBase& base) {
  const FirstFault first;
  first.add(find_name_fault(subsystem.name));
  visit_fields(subsystem, first);
  if (subsystem.bodies.empty() && !base.may_be_alone)
    first.add(
        {"body", "is missing, expected tables headed [[" + std::string(base.table) + ".body]]"});
  Names names;
  if (!first.found()) first.add(find_body_faults(subsystem, base, names));
  std::set<std::string_view> joint_names;
  for (std::size_t i = 0; i < subsystem.joints.size() && !first.found(); ++i) {
    const SubsystemJoint& joint = subsystem.joints[i];
    const std::string path = "joint." + std::to_string(i + 1);
    first.add(find_link_fault(joint, subsystem, base, names).within(path));
    first.add(find_fault(joint.joint).within(path));
    if (!first.found())
      first.add(find_axis_fault(joint, subsystem.bodies[names.at(joint.child)]).within(path));
    if (!joint.joint.name.empty() && !joint_names.insert(joint.joint.name).second)
      first.add({path + ".name",
                 "is \"" + joint.joint.name + "\" as another joint's, expected a name of its own"});
  }
  if (!first.found()) first.add(find_shape_fault(subsystem, base, names));
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
