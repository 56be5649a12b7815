// Reads places by what carries them, and the keys that only some kinds of closure have.

#include "models/reader/loop_reader.h"

#include <algorithm>

#include "models/reader/bearing_reader.h"
#include "models/reader/keys/loop_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/loop_ends.h"
#include "models/reader/spatial/vector_reader.h"

namespace spoke {
namespace {

using spatial::place_shape;
using spatial::rotation_shape;

constexpr LoopKind kKinds[] = {LoopKind::fixed,     LoopKind::revolute,  LoopKind::prismatic,
                               LoopKind::universal, LoopKind::spherical, LoopKind::cylindrical,
                               LoopKind::bearing,   LoopKind::distance};

/// Returns the number of axes that a file gives.
int count_axes(LoopKind kind, bool in_plane) {
  return in_plane ? (kind == LoopKind::prismatic ? 1 : 0) : count_axes(kind);
}

LoopKind read_kind(const TomlSection& section, bool in_plane) {
  const keys::Rows rows = in_plane ? keys::Rows(keys::kLoopRows) : keys::kSpaceLoopRows;
  std::vector<LoopKind> kinds;
  for (const LoopKind kind : kKinds)
    if (count_locked(kind, in_plane) > 0) kinds.push_back(kind);
  return kinds[keys::read_word(section, rows, "kind")];
}

/// Refuses a key of other kinds of closure, which would be ignored.
template <class Has>
void require_kind(const TomlSection& section, std::string_view key, LoopKind own, bool in_plane,
                  const Has& has) {
  if (!section.has(key) || has(own)) return;
  TomlSection::Keys fitting;
  for (const LoopKind kind : kKinds)
    if (count_locked(kind, in_plane) > 0 && has(kind)) fitting.push_back(name_of(kind));
  section.fail(key, "does not belong to kind \"" + std::string(name_of(own)) +
                        "\", expected only with kind " + join_names(fitting));
}

void check_kind_keys(const TomlSection& section, LoopKind kind, bool in_plane) {
  const auto require = [&](std::string_view key, const auto& has) {
    require_kind(section, key, kind, in_plane, has);
  };
  require("axis", [&](LoopKind k) { return count_axes(k, in_plane) == 1; });
  require("axes", [&](LoopKind k) { return count_axes(k, in_plane) == 2; });
  require("length", [](LoopKind k) { return k == LoopKind::distance; });
  require("speed", [](LoopKind k) { return k == LoopKind::bearing; });
  for (const std::string_view key : {"stiffness", "damping"})
    if (section.is_nested(key) && kind != LoopKind::bearing)
      section.fail(key, std::string(kMatrixOfOther));
}

/// Reads a place on another blade or subsystem, of which all else is looked at later.
void read_place_elsewhere(const TomlSection& table, LoopPlace& place) {
  read_elsewhere(table, place.blade, place.subsystem);
  if (table.has("anchor"))
    table.fail("anchor", std::string("given along with ") +
                             (table.has("blade") ? "blade" : "subsystem") +
                             ", expected only one of them");
  place.carrier = LoopPlace::Carrier::elsewhere;
  place.name = table.text("body", "");
}

/// Reads what carries a place by its name.
void read_carrier(const TomlSection& table, const LoopSurroundings& around, LoopPlace& place) {
  if (table.has("blade") || table.has("subsystem")) return read_place_elsewhere(table, place);
  if (table.has("anchor")) {
    if (table.has("body")) table.fail("anchor", "given along with body, expected only one of them");
    place.carrier = LoopPlace::Carrier::anchor;
    place.name = table.text("anchor", "");
    return;
  }
  const std::string name = table.text("body", "");
  if (name == around.base_name()) {
    place.carrier = LoopPlace::Carrier::hub;
  } else if (name == "mount" && !around.is_support()) {
    place.carrier = LoopPlace::Carrier::mount;
  } else {
    place.name = name;
  }
}

/// Reads station and point. On a beam a point alone has its station in its first component.
void read_point(const TomlSection& table, const LoopSurroundings& around, LoopPlace& place) {
  if (table.has("station")) place.station = table.number("station", kStation);
  if (!table.has("point")) return;
  place.point = spatial::read_vector(table, "point", kLength, place_shape(around.in_plane));
  const LoopBody* body = place.carrier == LoopPlace::Carrier::body ? around.find(place) : nullptr;
  if (body == nullptr || !body->length || place.station) return;
  place.station = place.point.x();
  place.point.x() = 0.0;
  if (const Fault fault = find_fault(place, around); fault.path == "station")
    table.fail_at("point.1", fault.text);
}

TomlSection::Keys place_keys(bool in_plane) {
  return in_plane ? keys::keys_of(keys::kPlaceRows) : keys::keys_of(keys::kSpacePlaceRows);
}

LoopPlace read_place(const TomlSection& section, std::string_view key,
                     const LoopSurroundings& around) {
  const std::string base(around.base_name());
  const std::string expected = '"' + base + (around.is_support() ? "\"" : "\", \"mount\"") +
                               ", or a table with body" +
                               (around.is_blade() ? ", anchor or station" : " or anchor");
  if (!section.has(key)) section.fail(key, "is missing, expected " + expected);
  LoopPlace place;
  if (section.is_text(key)) {
    const std::string text = section.text(key, "");
    if (text != base && (text != "mount" || around.is_support()))
      section.fail_expected(key, expected);
    place.carrier = text == base ? LoopPlace::Carrier::hub : LoopPlace::Carrier::mount;
    return place;
  }
  if (!section.is_table(key)) section.fail_expected(key, expected);
  const TomlSection table = section.section(key, place_keys(around.in_plane));
  read_carrier(table, around, place);
  place.interface = table.text("interface", "");
  read_point(table, around, place);
  if (table.has("orientation"))
    place.orientation = spatial::read_vector(table, "orientation", spatial::kAngle,
                                             rotation_shape(around.in_plane));
  return place;
}

void read_axes(const TomlSection& section, bool in_plane, Loop& loop) {
  const int count = count_axes(loop.kind, in_plane);
  if (count == 1)
    loop.axes[0] =
        spatial::read_vector(section, "axis", spatial::kDirection, place_shape(in_plane));
  if (count != 2) return;
  const auto rows = section.rows("axes", spatial::kDirection, 3);
  if (rows.size() != 2) section.fail_expected("axes", "2 arrays of 3 numbers");
  for (std::size_t i = 0; i < 2; ++i) loop.axes[i] = spatial::Vector::Map(rows[i].data());
}

/// Reads numbers by locked direction, or one for all; none if all are 0.
std::vector<double> read_springs(const TomlSection& section, std::string_view key, const Loop& loop,
                                 bool in_plane) {
  if (!section.has(key) || section.is_nested(key)) return {};
  const auto count = static_cast<std::size_t>(count_locked(loop.kind, in_plane));
  const bool are_lengths = count_locked_places(loop.kind, in_plane) == static_cast<int>(count);
  const char* unit = key == "damping" ? (are_lengths ? "N s/m" : "N s/m, N m s/rad")
                                      : (are_lengths ? "N/m" : "N/m, N m/rad");
  const std::vector<double> values =
      section.is_array(key)
          ? section.numbers(key, Quantity::not_negative(unit), count)
          : std::vector<double>(count, section.number(key, Quantity::not_negative(unit)));
  const bool is_any = std::any_of(values.begin(), values.end(), [](double v) { return v != 0.0; });
  return is_any ? values : std::vector<double>{};
}

/// Reads springs and dampers. One number for all dampers is for those directions that have springs.
void read_springs(const TomlSection& section, bool in_plane, Loop& loop) {
  loop.matrices = read_matrices(section);
  if (loop.matrices && !loop.matrices->speed.empty()) return;
  loop.stiffness = read_springs(section, "stiffness", loop, in_plane);
  loop.damping = read_springs(section, "damping", loop, in_plane);
  if (section.is_array("damping") || loop.damping.empty()) return;
  for (std::size_t i = 0; i < loop.stiffness.size(); ++i)
    if (loop.stiffness[i] == 0.0) loop.damping[i] = 0.0;
}

Loop read_loop(const TomlSection& section, const LoopSurroundings& around) {
  Loop loop;
  if (!section.has("name")) section.fail("name", "is missing, expected a name");
  loop.name = section.text("name", "");
  loop.kind = read_kind(section, around.in_plane);
  check_kind_keys(section, loop.kind, around.in_plane);
  loop.from = read_place(section, "from", around);
  loop.to = read_place(section, "to", around);
  read_axes(section, around.in_plane, loop);
  if (section.has("length")) loop.length = section.number("length", Quantity::positive("m"));
  read_springs(section, around.in_plane, loop);
  return loop;
}

/// Reads what moves an anchor: courses over time, or the embedding program.
void read_motion(const TomlSection& section, bool in_plane, Anchor& anchor) {
  if (!section.has("motion")) return;
  const TomlSection motion = section.section("motion", keys::keys_of(keys::kAnchorMotionRows));
  const auto& place = place_shape(in_plane);
  const auto& rotation = rotation_shape(in_plane);
  if (motion.has("by")) {
    keys::read_word(motion, keys::kAnchorMotionRows, "by");
    ProgramAnchorMotion program;
    if (motion.has("translation"))
      program.translation = spatial::read_vector(motion, "translation", kLength, place);
    if (motion.has("rotation"))
      program.rotation = spatial::read_vector(motion, "rotation", spatial::kAngle, rotation);
    anchor.motion = program;
    return;
  }
  if (!motion.has("translation") && !motion.has("rotation"))
    motion.fail("", "has none of translation, rotation and by, expected one or more");
  anchor.motion = spatial::MountMotion{spatial::read_course(motion, "translation", "m", place),
                                       spatial::read_course(motion, "rotation", "rad", rotation)};
}

}  // namespace

void read_elsewhere(const TomlSection& table, int& blade, std::string& subsystem) {
  if (table.has("blade") && table.has("subsystem"))
    table.fail("blade", "given along with subsystem, expected only one of them");
  subsystem = table.text("subsystem", "");
  if (!table.has("blade")) return;
  if (table.is_text("blade"))
    table.choice("blade", {"next"});
  else
    blade = table.integer("blade", {1, kMostOfAKind});
  if (blade == 0) blade = spatial::kNextBlade;
}

std::vector<Loop> read_loops(const TomlSection& parent, const LoopSurroundings& around) {
  const TomlSection::Keys keys =
      around.in_plane ? keys::keys_of(keys::kLoopRows) : keys::keys_of(keys::kSpaceLoopRows);
  std::vector<Loop> loops;
  for (const TomlSection& section : parent.sections("loop", keys))
    loops.push_back(read_loop(section, around));
  if (const Fault fault = find_fault(loops, around)) parent.fail_at(fault.path, fault.text);
  return loops;
}

namespace {

/// Reads the frame of an anchor: of a known name, or of a body, of which there may be any in space.
void read_frame(const TomlSection& section, Anchor& anchor) {
  const std::string frame = section.text("frame", std::string(name_of(Anchor::Frame::mount)));
  for (const Anchor::Frame known : {Anchor::Frame::mount, Anchor::Frame::hub, Anchor::Frame::axle})
    if (frame == name_of(known)) anchor.frame = known;
  if (frame != name_of(anchor.frame)) {
    anchor.frame = Anchor::Frame::body;
    anchor.body = frame;
  }
  if (anchor.frame != Anchor::Frame::body) {
    for (const char* key : {"subsystem", "station", "interface"})
      if (section.has(key))
        section.fail(key, "is given, but the frame is \"" + frame +
                              "\", expected it only with the name of a body");
    return;
  }
  anchor.subsystem = section.text("subsystem", "");
  if (section.has("station")) anchor.station = section.number("station", kStation);
  anchor.interface = section.text("interface", "");
}

}  // namespace

std::vector<Anchor> read_anchors(const TomlSection& root, const std::string& mount_fault,
                                 const RotorReader& read_rotor) {
  const bool in_plane = !read_rotor;
  std::vector<Anchor> anchors;
  for (const TomlSection& section : root.sections("anchor", keys::keys_of(keys::kAnchorRows))) {
    Anchor anchor;
    if (!section.has("name")) section.fail("name", "is missing, expected a name");
    anchor.name = section.text("name", "");
    keys::read(section, keys::kAnchorRows, &anchor);
    read_frame(section, anchor);
    if (read_rotor)
      anchor.rotor = read_rotor(section);
    else if (section.has("rotor"))
      section.fail("rotor", "names a rotor in space, expected none in the plane");
    read_motion(section, in_plane, anchor);
    if (const Fault fault = find_fault(anchor, anchors, mount_fault, in_plane))
      section.fail_at(fault.path, fault.text);
    anchors.push_back(std::move(anchor));
  }
  return anchors;
}

}  // namespace spoke
