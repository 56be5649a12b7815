// Reads subsystems: bodies by name, and the joints between them.

#include <algorithm>
#include <numbers>
#include <set>

#include "models/reader/loop_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/body_reader.h"
#include "models/reader/spatial/coupling_faults.h"
#include "models/reader/spatial/coupling_reader.h"
#include "models/reader/spatial/drag_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/joint_reader.h"
#include "models/reader/spatial/section_reader.h"
#include "models/reader/spatial/solid_reader.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/reader/spatial/vector_reader.h"

namespace spoke::spatial {
namespace {

TomlSection::Keys rigid_keys() { return keys::keys_of(keys::kRigidBodyRows); }

/// Refuses keys of the other kinds of bodies, which would be ignored.
void check_kind_keys(const TomlSection& section, const TomlSection::Keys& own, const char* kind) {
  for (const TomlSection::Keys& keys : {rigid_keys(), beam_keys(), solid_keys()})
    for (const std::string_view key : keys)
      if (section.has(key) && std::find(own.begin(), own.end(), key) == own.end())
        section.fail(key, "does not belong to kind \"" + std::string(kind) + '"');
}

Beam read_beam(const TomlSection& section) {
  check_kind_keys(section, beam_keys(), "beam");
  Beam beam;
  keys::read(section, keys::kBeamRows, &beam);
  beam.sections = read_sections(section, beam.length);
  beam.point_masses = read_point_masses(section);
  return beam;
}

RigidBody read_rigid_body(const TomlSection& section) {
  check_kind_keys(section, rigid_keys(), "rigid");
  RigidBody body;
  keys::read(section, keys::kRigidBodyRows, &body);
  body.inertia = read_inertia(section, "inertia", MayBeZero::no);
  return body;
}

/// What bodies are read with.
struct Around {
  const std::string& folder;             ///< of the scenario
  const std::vector<Subsystem>& before;  ///< subsystems that are read already
};

Body read_body(const TomlSection& section, const Around& around, const Subsystem& own) {
  Body body;
  body.name = read_name(section, "name");
  const std::size_t kind = keys::read_word(section, keys::kBodyRows, "kind");
  if (kind == 0) {
    body.shape = read_beam(section);
  } else if (kind == 1) {
    body.shape = read_rigid_body(section);
  } else {
    check_kind_keys(section, solid_keys(), "solid");
    body.shape = read_solid(section, around.folder, around.before, own);
    if (section.has("drag"))
      section.fail("drag", "does not belong to kind \"solid\", expected a beam or a rigid body");
  }
  if (section.has("drag")) body.drag = read_drag(section, body);
  return body;
}

SubsystemJoint read_subsystem_joint(const TomlSection& section, const Subsystem& subsystem,
                                    const TreeBase& base) {
  SubsystemJoint joint;
  joint.parent = base.is_support ? section.text("parent", std::string(base.name))
                                 : read_name(section, "parent");
  joint.child = read_name(section, "child");
  joint.station = read_station(section, subsystem, joint.parent);
  joint.interface = section.text("interface", "");
  joint.joint = read_joint(section);
  return joint;
}

TomlSection::Keys all_body_keys() {
  return keys::keys_of(keys::kBeamRows, keys::kBodyRows, keys::kRigidBodyRows, keys::kSolidRows);
}

Subsystem read_subsystem(const TomlSection& section, const Model& model, const std::string& folder,
                         const std::vector<Subsystem>& before) {
  Subsystem subsystem;
  subsystem.name = read_name(section, "name");
  keys::read(section, keys::kSubsystemRows, &subsystem);
  subsystem.rotor = read_rotor_of(section, model);
  if (subsystem.name == kSupportName)
    section.fail("name", "is \"support\", which is the name of [support]; expected another one");
  read_tree(section, model, folder, before, subsystem);
  return subsystem;
}

constexpr Count kCopies{1, kMostOfAKind};

/// Returns the subsystems that a table describes, as many as its count, evenly spaced.
std::vector<Subsystem> copy(const TomlSection& section, const Subsystem& subsystem) {
  if (!section.has("count")) return {subsystem};
  const int count = section.integer("count", kCopies);
  std::vector<Subsystem> copies(static_cast<std::size_t>(count), subsystem);
  const std::string name = subsystem.name;
  for (int i = 0; i < count; ++i) {
    Subsystem& made = copies[static_cast<std::size_t>(i)];
    for (Loop& loop : made.loops)
      if (loop.to.subsystem == "next")
        loop.to.subsystem = name + std::to_string((i + 1) % count + 1);
    made.name += std::to_string(i + 1);
    made.azimuth += 2.0 * std::numbers::pi * i / count;
    if (const Fault fault = find_name_fault(made.name)) section.fail_at(fault.path, fault.text);
  }
  return copies;
}

/// Returns the tables of subsystems.
std::vector<TomlSection> find_tables(const TomlSection& root) {
  return root.sections("subsystem", keys::keys_of(keys::kSubsystemRows, keys::kTreeRows));
}

}  // namespace

std::string read_name(const TomlSection& section, std::string_view key) {
  if (!section.has(key)) section.fail(key, "is missing, expected a name");
  return section.text(key, "");
}

std::optional<double> read_station(const TomlSection& section, const Subsystem& tree,
                                   const std::string& body) {
  if (!section.has("node"))
    return section.has("station") ? std::optional(section.number("station", kStation))
                                  : std::nullopt;
  if (section.has("station")) section.fail("node", "given along with station, expected only one");
  for (const Body& carrier : tree.bodies) {
    const auto* beam = std::get_if<Beam>(&carrier.shape);
    if (carrier.name != body || beam == nullptr) continue;
    const int nodes = beam->bodies * beam->elements;
    return beam->length * section.integer("node", {0, nodes}) / nodes;
  }
  section.fail("node", "would be ignored, expected only on a parent that is a beam: give offset");
}

void read_tree(const TomlSection& section, const Model& model, const std::string& folder,
               const std::vector<Subsystem>& before, Subsystem& tree) {
  const TomlSection::Keys joint_keys = keys::keys_of(keys::kJointRows, keys::kSubsystemJointRows);
  const TreeBase base = base_of(tree, model);
  for (const TomlSection& table : section.sections("body", all_body_keys()))
    tree.bodies.push_back(read_body(table, {folder, before}, tree));
  for (const TomlSection& table : section.sections("joint", joint_keys))
    tree.joints.push_back(read_subsystem_joint(table, tree, base));
  if (const Fault fault = find_fault(tree, base)) section.fail_at(fault.path, fault.text);
  tree.loops = read_loops(section, surroundings_of(tree, model));
  tree.couplings = read_couplings(section);
  if (const Fault fault = find_fault(tree.couplings, ends_of(tree, model)))
    section.fail_at(fault.path, fault.text);
  tree.couplings = read_couplings(section);
}

std::vector<Subsystem> read_subsystems(const TomlSection& root, const Model& model,
                                       const std::string& folder) {
  std::vector<Subsystem> subsystems;
  std::set<std::string> names;
  for (const TomlSection& section : find_tables(root)) {
    const Subsystem read = read_subsystem(section, model, folder, subsystems);
    for (Subsystem& subsystem : copy(section, read)) {
      if (!names.insert(subsystem.name).second)
        section.fail("name", "is \"" + subsystem.name +
                                 "\" as another subsystem's, expected a name of its own");
      subsystems.push_back(std::move(subsystem));
    }
  }
  return subsystems;
}

std::vector<std::string> find_copies(const TomlSection& root, const std::string& name) {
  for (const TomlSection& section : find_tables(root)) {
    if (!section.has("count") || section.text("name", "") != name) continue;
    std::vector<std::string> names;
    const int count = section.integer("count", kCopies);
    for (int i = 1; i <= count; ++i) names.push_back(name + std::to_string(i));
    return names;
  }
  return {name};
}

}  // namespace spoke::spatial
