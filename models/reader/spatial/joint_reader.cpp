// Reads keys that only some kinds of joint have; each holds one number, or one for each coordinate.

#include "models/reader/spatial/joint_reader.h"

#include <algorithm>
#include <iterator>

#include "models/count_text.h"
#include "models/reader/curve_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/vector_reader.h"

namespace spoke::spatial {
namespace {

/// Refuses keys of other kinds of joint, which would be ignored.
void check_kind_keys(const TomlSection& section, std::string_view kind) {
  struct Key {
    std::string_view name;
    TomlSection::Keys kinds;
  };
  TomlSection::Keys moving = keys::words_of(keys::kJointRows, "kind");
  moving.erase(moving.begin());  // "fixed"
  const TomlSection::Keys bounded = {"revolute", "universal", "prismatic", "cylindrical"};
  TomlSection::Keys at_rest = bounded;
  at_rest.push_back("bushing");
  const std::vector<Key> keys = {{"axis", {"revolute", "prismatic", "cylindrical"}},
                                 {"axes", {"universal"}},
                                 {"stiffness", moving},
                                 {"damping", moving},
                                 {"initial", moving},
                                 {"initial_speed", moving},
                                 {"hold", moving},
                                 {"free", {"bushing"}},
                                 {"rest", at_rest},
                                 {"relaxation", at_rest},
                                 {"stop", bounded},
                                 {"friction", bounded},
                                 {"motion", bounded},
                                 {"torque", {"revolute", "universal", "spherical", "cylindrical"}},
                                 {"force", {"prismatic", "cylindrical"}}};
  for (const Key& key : keys) {
    if (!section.has(key.name)) continue;
    if (std::find(key.kinds.begin(), key.kinds.end(), kind) != key.kinds.end()) continue;
    section.fail(key.name, "does not belong to kind \"" + std::string(kind) +
                               "\", expected only with kind " + join_names(key.kinds));
  }
}

void read_axes(const TomlSection& section, Joint& joint) {
  if (count_axes(joint.kind) == 1) joint.axes[0] = read_vector(section, "axis", kDirection);
  if (count_axes(joint.kind) != 2) return;
  const auto rows = section.rows("axes", kDirection, 3);
  if (rows.size() != 2) section.fail_expected("axes", "2 arrays of 3 numbers");
  for (std::size_t i = 0; i < 2; ++i) joint.axes[i] = Vector::Map(rows[i].data());
}

/// Reads the numbers of the coordinates: one, or an array of one for each; of a spherical joint's
/// spring and damper one for all three.
void read_numbers(const TomlSection& section, Joint& joint) {
  const auto count = static_cast<std::size_t>(count_coordinates(joint.kind));
  const bool is_spherical = joint.kind == JointKind::spherical;
  const bool is_bushing = joint.kind == JointKind::bushing;
  for (std::size_t i = 0; i < count; ++i)
    visit_fields(joint.coordinates[i],
                 is_bushing ? kBushingUnits : units_of(joint.kind, static_cast<int>(i)),
                 [&](std::string_view key, double& value, const Quantity& quantity) {
                   if (!section.has(key)) return;
                   const bool is_one = is_spherical && (key == "stiffness" || key == "damping");
                   value = count == 1 || is_one ? section.number(key, quantity)
                                                : section.numbers(key, quantity, count)[i];
                 });
}

/// Frees the directions of a bushing that are named.
void free_directions(const TomlSection& section, Joint& joint) {
  if (!section.has("free")) return;
  const std::string expected =
      R"(an array of directions: "x", "y", "z", "about x", "about y", "about z")";
  for (const TomlValue& value : section.values("free")) {
    const std::string* name = value.as_text();
    if (!name) section.fail_expected("free", expected);
    const auto at = std::find(kBushingDirections.begin(), kBushingDirections.end(), *name);
    if (at == kBushingDirections.end())
      section.fail("free", "has \"" + *name + "\", expected " + expected);
    joint.coordinates[static_cast<std::size_t>(at - kBushingDirections.begin())].moves_freely =
        true;
  }
}

/// Holds the directions of a bushing that have neither spring nor damper, and are not free.
void hold_directions(Joint& joint) {
  for (JointCoordinate& coordinate : joint.coordinates)
    if (coordinate.stiffness == 0.0 && coordinate.damping == 0.0 && !coordinate.moves_freely)
      coordinate.motion = MotionTable{};
}

/// Reads the efforts of `count` coordinates from `first` on: a number, an array of as many, or a
/// table with time and value.
void read_effort(const TomlSection& section, std::string_view key, const Quantity& quantity,
                 JointCoordinate* first, std::size_t count) {
  if (!section.has(key)) return;
  if (section.is_table(key)) {
    const TomlSection table = section.section(key, keys::keys_of(keys::kEffortRows));
    if (count == 1) {
      first->effort = read_curve(table, "time", kTime, "value", quantity);
      return;
    }
    const std::vector<double> times = table.increasing_numbers("time", kTime);
    const auto rows = table.rows("value", quantity, count);
    if (rows.size() != times.size())
      table.fail("value", "has " + counted(std::ssize(rows), "array") + ", expected " +
                              std::to_string(times.size()) + ", one for each of time");
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<double> values;
      for (const std::vector<double>& row : rows) values.push_back(row[i]);
      first[i].effort = Curve(times, values);
    }
    return;
  }
  const std::vector<double> values = count == 1 ? std::vector<double>{section.number(key, quantity)}
                                                : section.numbers(key, quantity, count);
  for (std::size_t i = 0; i < count; ++i) first[i].effort = Curve(values[i]);
}

std::optional<Motion> read_motion(const TomlSection& table, const CoordinateUnits& unit) {
  const Quantity quantity = Quantity::any(unit.position);
  const auto refuse_others = [&](std::initializer_list<std::string_view> own) {
    for (const std::string_view key :
         {"constant", "time", "value", "mean", "cosine", "sine", "by", "initial"})
      if (table.has(key) && std::find(own.begin(), own.end(), key) == own.end())
        table.fail(key, "given along with " + std::string(*own.begin()) +
                            ", expected only one kind of motion");
  };
  if (table.has("constant")) {
    refuse_others({"constant"});
    return MotionTable{Curve(table.number("constant", quantity))};
  }
  if (table.has("by")) {
    refuse_others({"by", "initial"});
    keys::read_word(table, keys::kMotionRows, "by");
    return ProgramMotion{table.number("initial", quantity, 0.0)};
  }
  if (table.has("mean") || table.has("cosine") || table.has("sine")) {
    refuse_others({"mean", "cosine", "sine"});
    AzimuthMotion motion;
    visit_fields(motion, unit, FieldReader{table});
    return motion;
  }
  if (table.has("initial")) table.fail("initial", "would be ignored, expected only with \"by\"");
  if (!table.has("time") && !table.has("value")) return std::nullopt;
  return MotionTable{read_curve(table, "time", kTime, "value", quantity)};
}

/// Calls read(table, coordinate) for the table of each coordinate that has one.
template <class Read>
void read_tables(const TomlSection& section, std::string_view key, const TomlSection::Keys& keys,
                 const Joint& joint, const Read& read) {
  if (!section.has(key)) return;
  const auto count = static_cast<std::size_t>(count_coordinates(joint.kind));
  if (count == 1) return read(section.section(key, keys), std::size_t{0});
  const std::string expected =
      std::to_string(count) + " tables, one for each coordinate; {} for one that has none";
  if (!section.is_array(key)) section.fail_expected(key, "an array of " + expected);
  const std::vector<TomlSection> tables = section.sections(key, keys);
  if (tables.size() != count) section.fail_expected(key, expected);
  for (std::size_t i = 0; i < count; ++i) read(tables[i], i);
}

void read_stops(const TomlSection& section, Joint& joint) {
  read_tables(section, "stop", keys::keys_of(keys::kStopRows), joint,
              [&](const TomlSection& table, std::size_t i) {
                if (joint.kind != JointKind::revolute && joint.kind != JointKind::prismatic &&
                    !table.has("lower") && !table.has("upper") && !table.has("stiffness"))
                  return;
                Stop stop;
                visit_fields(stop, units_of(joint.kind, static_cast<int>(i)), FieldReader{table});
                joint.coordinates[i].stop = stop;
              });
}

Friction read_friction(const TomlSection& table, const CoordinateUnits& unit) {
  Friction friction;
  friction.force = table.number("force", Quantity::positive(unit.effort));
  friction.speed = table.number("speed", Quantity::positive(unit.speed));
  if (table.has("static"))
    friction.static_force = table.number("static", Quantity::positive(unit.effort));
  if (table.has("stribeck"))
    friction.stribeck = table.number("stribeck", Quantity::positive(unit.speed));
  return friction;
}

void read_frictions(const TomlSection& section, Joint& joint) {
  const bool may_be_empty = count_coordinates(joint.kind) > 1;
  read_tables(section, "friction", keys::keys_of(keys::kFrictionRows), joint,
              [&](const TomlSection& table, std::size_t i) {
                if (may_be_empty && !table.has("force") && !table.has("speed") &&
                    !table.has("static") && !table.has("stribeck"))
                  return;
                joint.coordinates[i].friction =
                    read_friction(table, units_of(joint.kind, static_cast<int>(i)));
              });
}

void read_relaxations(const TomlSection& section, Joint& joint) {
  read_tables(
      section, "relaxation", keys::keys_of(keys::kRelaxationRows), joint,
      [&](const TomlSection& table, std::size_t i) {
        if (count_coordinates(joint.kind) > 1 && !table.has("stiffness") && !table.has("time"))
          return;
        Relaxation relaxation;
        visit_fields(relaxation, units_of(joint.kind, static_cast<int>(i)), FieldReader{table});
        joint.coordinates[i].relaxation = relaxation;
      });
}

void read_motions(const TomlSection& section, Joint& joint) {
  read_tables(section, "motion", keys::keys_of(keys::kMotionRows), joint,
              [&](const TomlSection& table, std::size_t i) {
                joint.coordinates[i].motion =
                    read_motion(table, units_of(joint.kind, static_cast<int>(i)));
                if (!joint.coordinates[i].motion && count_coordinates(joint.kind) == 1)
                  table.fail("",
                             "is empty, expected constant, time and value, mean, cosine and "
                             "sine, or by = \"program\"");
              });
}

}  // namespace

Joint read_joint(const TomlSection& section) {
  Joint joint;
  joint.name = section.text("name", "");
  joint.kind = static_cast<JointKind>(keys::read_word(section, keys::kJointRows, "kind"));
  if (joint.kind == JointKind::bushing) joint.coordinates.resize(6);
  check_kind_keys(section, name_of(joint.kind));
  keys::read(section, keys::kJointRows, &joint);
  read_axes(section, joint);
  read_numbers(section, joint);
  const bool has_way = slides(joint.kind, count_coordinates(joint.kind) - 1);
  const std::size_t angles =
      static_cast<std::size_t>(count_coordinates(joint.kind)) - (has_way ? 1 : 0);
  if (angles > 0)
    read_effort(section, "torque", Quantity::any("N m"), joint.coordinates.data(), angles);
  if (has_way)
    read_effort(section, "force", Quantity::any("N"), joint.coordinates.data() + angles, 1);
  read_relaxations(section, joint);
  read_stops(section, joint);
  read_frictions(section, joint);
  read_motions(section, joint);
  if (joint.kind == JointKind::bushing) {
    free_directions(section, joint);
    hold_directions(joint);
  }
  if (const Fault fault = find_fault(joint)) section.fail_at(fault.path, fault.text);
  return joint;
}

}  // namespace spoke::spatial
