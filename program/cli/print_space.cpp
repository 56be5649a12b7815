// Lines of a tree: each joint, and behind it the bodies that it carries.

#include "program/cli/print_space.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "models/count_text.h"
#include "models/reader/keys/control_keys.h"
#include "models/reader/keys/turbine_keys.h"
#include "models/tree/space_beam.h"
#include "models/tree/tree.h"
#include "program/cli/report.h"

namespace spoke::cli {
namespace {

using spatial::Joint;
using spatial::MassProperties;
using spatial::Tree;
using spatial::TreeBody;

/// Formats a number with six digits; round-off beside `size` becomes 0.
std::string number(double value, double size = 0.0) {
  return fmt::format("{:.6g}", std::abs(value) <= 1e-12 * size ? 0.0 : value);
}

std::string vector(const spatial::Vector& v, double size) {
  return fmt::format("[{}, {}, {}]", number(v.x(), size), number(v.y(), size), number(v.z(), size));
}

/// Whether a body goes on where its parent, of the same beam, ends.
bool continues_beam(const Tree& tree, std::size_t index) {
  const TreeBody& body = tree.bodies[index];
  if (body.parent < 0 || body.joint.kind != spatial::JointKind::fixed || !body.joint.name.empty())
    return false;
  const auto* own = std::get_if<spatial::FlexibleBody>(&body.shape);
  const auto* parents =
      std::get_if<spatial::FlexibleBody>(&tree.bodies[static_cast<std::size_t>(body.parent)].shape);
  return own != nullptr && parents != nullptr && own->beam == parents->beam &&
         own->nodes.front() == parents->nodes.back();
}

/// Names the directions in which a bushing gives.
std::string describe_directions(const Joint& joint) {
  constexpr auto& names = spatial::kBushingDirections;
  std::string text;
  for (std::size_t c = 0; c < names.size(); ++c)
    if (!joint.coordinates[c].motion) text += (text.empty() ? "" : ", ") + std::string(names[c]);
  return ", gives in " + text;
}

std::string describe_coordinates(const Joint& joint) {
  if (joint.kind == spatial::JointKind::bushing) return describe_directions(joint);
  std::string text;
  for (int i = 0; i < count_coordinates(joint.kind); ++i) {
    const spatial::JointCoordinate& coordinate = joint.coordinates[static_cast<std::size_t>(i)];
    const bool is_sprung = coordinate.stiffness > 0.0;
    text += i == 0 ? ", " : " and ";
    text += coordinate.motion ? "prescribed" : is_sprung ? "sprung" : "free";
    if (joint.kind == spatial::JointKind::spherical) break;
  }
  if (joint.hold) text += ", held where loops are closed";
  return text;
}

std::string describe(const Joint& joint) {
  std::string text = joint.name.empty() ? "" : joint.name + ", ";
  text += name_of(joint.kind);
  for (int i = 0; i < count_axes(joint.kind); ++i)
    text += (i == 0 ? " about " : ", ") + vector(joint.axes[static_cast<std::size_t>(i)], 0.0);
  return text + describe_coordinates(joint);
}

/// The bodies from `first` on that are one part of a beam: their number and what they are.
struct Part {
  std::size_t bodies;
  std::string text;
  std::vector<std::string> further{};  ///< lines behind that of the joint
};

std::string describe_modes(const spatial::SolidBody& body) {
  if (body.coordinates == spatial::SolidCoordinates::nodal) return "nodal";
  if (body.up_to) return fmt::format("reduced, modes up to {} Hz", number(*body.up_to));
  return body.modes ? "reduced, " + counted(*body.modes, "mode") : "reduced";
}

/// Describes a solid by its mesh, and its interfaces by where they are.
Part describe_solid(const std::string& name, const spatial::SolidPart& solid) {
  const spatial::SolidBody& body = solid.body();
  const solid::SolidGeometry& at_rest = solid.geometry();
  const std::string source = body.matrices ? body.matrices->stiffness : body.file;
  const std::string file =
      source.empty() ? "" : " " + std::filesystem::path(source).filename().string();
  Part part{1, fmt::format("{} (solid{}, {}, {}, {} kg, {})", name, file,
                           counted(std::ssize(at_rest.mesh->nodes), "node"),
                           counted(std::ssize(at_rest.mesh->elements), "element"),
                           number(at_rest.mass), describe_modes(body))};
  double size = 0.0;
  for (const solid::ChosenNodes& chosen : at_rest.interfaces)
    size = std::max(size, chosen.point.norm());
  for (std::size_t i = 0; i < body.interfaces.size(); ++i) {
    const solid::ChosenNodes& chosen = at_rest.interfaces[i];
    const std::string area = chosen.area > 0.0 ? fmt::format(", {} m^2", number(chosen.area)) : "";
    part.further.push_back(fmt::format(
        "interface {}: {}, {} at {} m{}", body.interfaces[i].name, name_of(body.interfaces[i].kind),
        counted(std::ssize(chosen.nodes), "node"), vector(chosen.point, size), area));
  }
  return part;
}

Part describe_part(const Tree& tree, std::size_t first) {
  const TreeBody& body = tree.bodies[first];
  if (const auto* rigid = std::get_if<spatial::RigidBody>(&body.shape))
    return {1, body.is_generator()
                   ? fmt::format("{} ({} kg m^2, {} turns for one of the hub)", body.name,
                                 number(rigid->inertia(2, 2)), number(body.drive_ratio))
                   : fmt::format("{} (rigid, {} kg)", body.name, number(rigid->mass))};
  if (const auto* solid = std::get_if<spatial::SolidPart>(&body.shape))
    return describe_solid(body.name, *solid);
  const auto& innermost = std::get<spatial::FlexibleBody>(body.shape);
  std::size_t end = first + 1, elements = innermost.nodes.size() - 1;
  double tip = innermost.nodes.back();
  while (end < tree.bodies.size() && continues_beam(tree, end) &&
         tree.bodies[end].parent == static_cast<int>(end) - 1) {
    const auto& nodes = std::get<spatial::FlexibleBody>(tree.bodies[end].shape).nodes;
    elements += nodes.size() - 1;
    tip = nodes.back();
    ++end;
  }
  const std::string last = end == first + 1 ? "" : " ... " + tree.bodies[end - 1].name;
  const bool is_nonlinear = tree.beams[innermost.beam].strain == spatial::BeamStrain::nonlinear;
  return {end - first, fmt::format("{}{} (beam, {} to {} m, {}{})", body.name, last,
                                   number(innermost.nodes.front()), number(tip),
                                   counted(static_cast<std::int64_t>(elements), "element"),
                                   is_nonlinear ? ", nonlinear strains" : "")};
}

/// Names the body that a body is joined to, or the base of the tree.
std::string describe_parent(const Tree& tree, const TreeBody& body, const std::string& base) {
  if (body.parent < 0) return base;
  const TreeBody& parent = tree.bodies[static_cast<std::size_t>(body.parent)];
  if (const auto* solid = std::get_if<spatial::SolidPart>(&parent.shape))
    return parent.name + " at " + solid->body().interfaces[body.parent_node].name;
  const auto* beam = std::get_if<spatial::FlexibleBody>(&parent.shape);
  if (beam == nullptr) return parent.name;
  return fmt::format("{} at {} m", parent.name, number(beam->nodes[body.parent_node]));
}

/// Returns a line for each body or part of a beam with its parent and its joint, indented by the
/// joints between it and the base.
std::vector<std::string> describe(const Tree& tree, const std::string& base) {
  std::vector<std::string> lines;
  std::vector<std::size_t> depths(tree.bodies.size(), 0);
  for (std::size_t i = 0; i < tree.bodies.size();) {
    const TreeBody& body = tree.bodies[i];
    if (body.parent >= 0) depths[i] = depths[static_cast<std::size_t>(body.parent)] + 1;
    const Part part = describe_part(tree, i);
    for (std::size_t k = 1; k < part.bodies; ++k) depths[i + k] = depths[i];
    lines.push_back(fmt::format("{}{}, on {}: {}", std::string(2 * depths[i], ' '), part.text,
                                describe_parent(tree, body, base), describe(body.joint)));
    for (const std::string& line : part.further)
      lines.push_back(std::string(2 * depths[i] + 4, ' ') + line);
    i += part.bodies;
  }
  return lines;
}

std::vector<std::string> describe(const MassProperties& m, const char* where) {
  const spatial::Tensor& J = m.inertia;
  const auto entry = [&](int r, int c) { return number(J(r, c), J.norm()); };
  return {
      fmt::format("{} kg, first moment {} kg m", number(m.mass),
                  vector(m.first_moment, std::sqrt(m.mass * J.norm()))),
      fmt::format("inertia about {}: xx {}, yy {}, zz {}, xy {}, xz {}, yz {} kg m^2", where,
                  entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2))};
}

void print_lines(const std::string& label, const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) print_line(i == 0 ? label : "", lines[i]);
}

/// Returns the tree's mass properties in the frame of its first body; of a beam in that of the
/// whole beam, whose axis may begin beside its origin.
MassProperties seen_from_root(const Tree& tree) {
  const TreeBody& first = tree.bodies.front();
  const spatial::Tensor back = first.placement.rotation.transpose();
  spatial::Vector begin = spatial::Vector::Zero();
  if (const auto* beam = std::get_if<spatial::FlexibleBody>(&first.shape))
    begin = spatial::find_axis_begin(tree.beams[beam->beam].sections);
  return calc_mass_properties(tree).seen_from_outside(
      {begin - back * first.placement.position, back});
}

/// Returns the coordinates of a tree that are prescribed.
std::int64_t count_prescribed(const Tree& tree) {
  std::int64_t count = 0;
  for (const TreeBody& body : tree.bodies)
    for (int c = 0; c < count_coordinates(body.joint.kind); ++c)
      count += body.joint.coordinates[static_cast<std::size_t>(c)].motion.has_value();
  return count;
}

/// Returns the free coordinates of a hub, or of what its support stands on.
std::int64_t count_free(const spatial::Model& model) {
  const bool flies = model.support ? model.support->from == spatial::SupportBase::free
                                   : model.hub.support == HubSupport::free;
  if (flies) return 6;
  return model.support || prescribes_motion(model.hub.drive) ? 0 : 1;
}

void print_sizes(const spatial::Model& model, const std::vector<Tree>& trees) {
  std::int64_t bodies = 0, coordinates = count_free(model);
  bool are_most = false, have_further = false;
  for (const Tree& tree : trees) {
    bodies += std::ssize(tree.bodies);
    coordinates += count_coordinates(tree) - count_prescribed(tree);
    for (const TreeBody& body : tree.bodies) {
      const auto* solid = std::get_if<spatial::SolidPart>(&body.shape);
      if (!solid || solid->body().coordinates != spatial::SolidCoordinates::reduced) continue;
      (solid->body().up_to ? have_further : are_most) = true;
    }
  }
  print_line("model", "in space, " + counted(std::ssize(trees), "tree") + ", " +
                          counted(bodies, "body") +
                          (are_most && !have_further ? ", at most " : ", ") +
                          counted(coordinates, "coordinate") +
                          (have_further ? " and the modes up to a frequency" : ""));
}

/// Returns what a pitch controller does: "joint pitch, hub to 1.2671 rad/s, ...".
std::string describe(const PitchControl& control) {
  std::string text = control.joints.size() > 1 ? "joints" : "joint";
  for (std::size_t i = 0; i < control.joints.size(); ++i)
    text += (i > 0 ? ", " : " ") + control.joints[i];
  text += fmt::format("{}, hub to {} rad/s, {} to {} rad", control.sign < 0.0 ? " reversed" : "",
                      number(control.speed), number(control.minimum), number(control.maximum));
  if (control.rate) text += fmt::format(", at most {} rad/s", number(*control.rate));
  text += control.period ? fmt::format(", every {} s", number(*control.period))
                         : std::string(", every step");
  constexpr std::array<std::string_view, 7> kSaid{"speed",   "proportional", "integral", "minimum",
                                                  "maximum", "rate",         "period"};
  return text + keys::describe_others(keys::kPitchControlRows, &control, kSaid);
}

/// Returns what is called in samples: "library libdiscon.so, joint pitch, every 0.01 s".
std::string describe(const TurbineLaws& laws) {
  std::string text;
  keys::visit_laws(laws, [&text](std::string_view key, keys::Rows, const auto& part) {
    if (part) text += (text.empty() ? "" : " and ") + std::string(key);
  });
  if (laws.torque)
    text += fmt::format(", rated {} N m at {} rad/s", number(laws.torque->rated),
                        number(laws.torque->speed));
  return text;
}

std::string describe(const OuterControl& control) {
  std::string text = control.is_library() ? "library " + control.file : "of the program";
  if (control.laws) text = "laws of a turbine, " + describe(*control.laws);
  if (!control.has_controller) text = "by events alone";
  for (const std::string& joint : control.joints) text += ", joint " + joint;
  if (!control.yaw_joint.empty()) text += ", yaw by " + control.yaw_joint;
  if (!control.has_controller) return text;
  return text + (control.period ? fmt::format(", every {} s", number(*control.period))
                                : std::string(", every step"));
}

std::string describe(const Event& event, std::size_t index) {
  std::string text = name_of_event(event, index);
  text += event.at ? fmt::format(" at {} s", number(*event.at)) : " when " + event.when;
  return text + (event.delay > 0.0 ? fmt::format(", {} s later", number(event.delay)) : "");
}

}  // namespace

void print_space(const spatial::Model& model) {
  std::vector<Tree> trees = build_trees(model);
  // The hub, which stands at the end of a support, is the rotor's.
  const bool has_support = model.support.has_value();
  const std::string ground =
      has_support ? "the " + std::string(base_name(model.support->from)) : "";
  print_sizes(model, trees);
  std::vector<std::string> before;
  std::string example;
  for (const Tree& tree : trees) {
    const bool is_support = has_support && &tree == &trees.back();
    std::vector<std::string> lines = describe(tree, is_support ? ground : "the hub");
    for (std::string& line : describe(seen_from_root(tree), "its root"))
      lines.push_back(std::move(line));
    if (lines == before) {
      print_line(tree.name, "as " + example);
      continue;
    }
    print_lines(tree.name, lines);
    before = std::move(lines);
    example = tree.name;
  }
  if (has_support) trees.pop_back();
  for (int r = 0; r < spatial::count_rotors(model); ++r) {
    std::vector<Tree> own;
    for (const Tree& tree : trees)
      if (tree.rotor == r) own.push_back(tree);
    const spatial::Hub& hub = spatial::hub_of(model, r);
    const std::string name = hub.name.empty() ? "rotor" : hub.name;
    print_lines(has_support ? name : "all",
                describe(calc_mass_properties(hub, own), "the hub's origin"));
  }
  if (model.outer_control) print_line("control", describe(*model.outer_control));
  if (model.pitch_control) print_line("pitch", describe(*model.pitch_control));
  for (std::size_t k = 0; k < model.events.size(); ++k)
    print_line(k == 0 ? "events" : "", describe(model.events[k], k));
}

}  // namespace spoke::cli
