// Reads subsystems: bodies by name, and the joints between them.

#include "models/reader/loop_reader.h"
#include "models/reader/spatial/body_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/joint_reader.h"
#include "models/reader/spatial/section_reader.h"
#include "models/reader/spatial/vector_reader.h"

namespace spoke::spatial {
namespace {

std::string read_name(const TomlSection& section, std::string_view key) {
  if (!section.has(key)) section.fail(key, "is missing, expected a name");
  return section.text(key, "");
}

/// Refuses keys of the other kind of body, which would be ignored.
void check_kind_keys(const TomlSection& section, const TomlSection::Keys& others,
                     const char* kind) {
  for (const std::string_view key : others)
    if (section.has(key)) section.fail(key, "does not belong to kind \"" + std::string(kind) + '"');
}

Beam read_beam(const TomlSection& section) {
  check_kind_keys(section, {"mass", "center", "inertia"}, "beam");
  Beam beam;
  visit_fields(beam, FieldReader{section});
  beam.sections = read_sections(section, beam.length);
  beam.point_masses = read_point_masses(section);
  beam.geometric_stiffening = section.flag("geometric_stiffening", beam.geometric_stiffening);
  beam.reference_frame = section.choice(
      "reference_frame", {ReferenceFrame::clamped, ReferenceFrame::chord}, beam.reference_frame);
  return beam;
}

RigidBody read_rigid_body(const TomlSection& section) {
  check_kind_keys(section, beam_keys(), "rigid");
  RigidBody body;
  visit_fields(body, VectorReader{section});
  body.inertia = read_inertia(section, "inertia", MayBeZero::no);
  return body;
}

Body read_body(const TomlSection& section) {
  Body body;
  body.name = read_name(section, "name");
  if (section.choice("kind", {"beam", "rigid"}) == 0) {
    body.shape = read_beam(section);
  } else {
    body.shape = read_rigid_body(section);
  }
  return body;
}

/// Reads the place on the parent: "station", or "node" counted from the root of a beam.
std::optional<double> read_station(const TomlSection& section, const Subsystem& subsystem,
                                   const std::string& parent) {
  if (!section.has("node"))
    return section.has("station") ? std::optional(section.number("station", kStation))
                                  : std::nullopt;
  if (section.has("station")) section.fail("node", "given along with station, expected only one");
  for (const Body& body : subsystem.bodies) {
    const auto* beam = std::get_if<Beam>(&body.shape);
    if (body.name != parent || beam == nullptr) continue;
    const int nodes = beam->bodies * beam->elements;
    return beam->length * section.integer("node", {0, nodes}) / nodes;
  }
  section.fail("node", "would be ignored, expected only on a parent that is a beam: give offset");
}

SubsystemJoint read_subsystem_joint(const TomlSection& section, const Subsystem& subsystem) {
  SubsystemJoint joint;
  joint.parent = read_name(section, "parent");
  joint.child = read_name(section, "child");
  joint.station = read_station(section, subsystem, joint.parent);
  joint.joint = read_joint(section);
  return joint;
}

Subsystem read_subsystem(const TomlSection& section, const Model& model) {
  TomlSection::Keys body_keys = beam_keys();
  body_keys.insert(body_keys.end(), {"name", "kind", "mass", "center", "inertia"});
  TomlSection::Keys keys = joint_keys();
  keys.insert(keys.end(), {"parent", "child", "station", "node"});
  Subsystem subsystem;
  subsystem.name = read_name(section, "name");
  for (const TomlSection& table : section.sections("body", body_keys))
    subsystem.bodies.push_back(read_body(table));
  for (const TomlSection& table : section.sections("joint", keys))
    subsystem.joints.push_back(read_subsystem_joint(table, subsystem));
  if (const Fault fault = find_fault(subsystem)) section.fail_at(fault.path, fault.text);
  subsystem.loops = read_loops(section, surroundings_of(subsystem, model));
  return subsystem;
}

}  // namespace

std::vector<Subsystem> read_subsystems(const TomlSection& root, const Model& model) {
  std::vector<Subsystem> subsystems;
  for (const TomlSection& section : root.sections("subsystem", {"name", "body", "joint", "loop"})) {
    subsystems.push_back(read_subsystem(section, model));
    for (std::size_t i = 0; i + 1 < subsystems.size(); ++i)
      if (subsystems[i].name == subsystems.back().name)
        section.fail("name", "is \"" + subsystems[i].name +
                                 "\" as another subsystem's, expected a name of its own");
  }
  return subsystems;
}

}  // namespace spoke::spatial
