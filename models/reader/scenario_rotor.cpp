// Reads each table of the rotor: hub, drive, blades, gravity, damping.

#include "models/reader/scenario_rotor.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "models/reader/blade_sections.h"
#include "models/reader/curve_reader.h"
#include "models/reader/damping.h"
#include "models/reader/loop_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"
#include "models/reader/scenario_loads.h"
#include "models/scenario.h"

namespace spoke {
namespace {

using std::numbers::pi;

Curve read_torque(const TomlSection& drive) {
  if (drive.has("time")) return read_curve(drive, "time", kTime, "torque", kTorque);
  if (drive.is_array("torque")) {
    drive.fail_expected("torque", "a number (N m), or with an array also the array time (s)");
  }
  return Curve(drive.number("torque", kTorque));
}

/// Refuses keys of other kinds of drive, which would be ignored.
void check_drive_keys(const TomlSection& drive, std::string_view kind) {
  struct Key {
    std::string_view name;
    TomlSection::Keys kinds;
  };
  const std::vector<Key> keys = {
      {"speed", {"spin_up", "spin_up_hold_spin_down", "table", "constant", "torque_by_speed"}},
      {"ramp", {"spin_up", "spin_up_hold_spin_down", "torque_by_speed"}},
      {"hold", {"spin_up_hold_spin_down"}},
      {"ramp_down", {"spin_up_hold_spin_down"}},
      {"torque", {"torque", "torque_by_speed"}},
      {"time", {"torque", "table"}},
      {"initial_speed", {"torque", "free", "torque_by_speed"}}};
  for (const Key& key : keys) {
    if (!drive.has(key.name)) continue;
    if (std::find(key.kinds.begin(), key.kinds.end(), kind) != key.kinds.end()) continue;
    drive.fail(key.name, "does not belong to kind \"" + std::string(kind) +
                             "\", expected only with kind " + join_names(key.kinds));
  }
}

template <class Fields>
Fields read_fields(const TomlSection& section) {
  Fields fields;
  keys::read(section, rows_of(fields), &fields);
  return fields;
}

}  // namespace

Drive read_drive(const TomlSection& hub) {
  const TomlSection drive = hub.section(
      "drive",
      keys::keys_of(keys::kDriveKindRows, keys::kSpinUpHoldSpinDownRows, keys::kTorqueDriveRows));
  const std::string_view kind = keys::words_of(
      keys::kDriveKindRows, "kind")[keys::read_word(drive, keys::kDriveKindRows, "kind")];
  check_drive_keys(drive, kind);
  if (kind == "table") return SpeedTable{read_curve(drive, "time", kTime, "speed", kSpeed)};
  if (kind == "free") return read_fields<FreeDrive>(drive);
  if (kind == "fixed") return FixedDrive{};
  if (kind == "constant") return read_fields<ConstantSpeed>(drive);
  if (kind == "torque_by_speed") {
    auto by_speed = read_fields<TorqueBySpeed>(drive);
    by_speed.torque = read_curve(drive, "speed", kSpeed, "torque", kTorque);
    return by_speed;
  }
  if (kind == "torque") {
    const Curve torque = read_torque(drive);
    TorqueDrive torque_drive = read_fields<TorqueDrive>(drive);
    torque_drive.torque = torque;
    return torque_drive;
  }
  if (kind == "spin_up") return read_fields<SpinUp>(drive);
  auto up_and_down = read_fields<SpinUpHoldSpinDown>(drive);
  if (!drive.has("ramp_down")) up_and_down.ramp_down = up_and_down.ramp;
  return up_and_down;
}

namespace {

Hub read_hub(const TomlSection& root) {
  const TomlSection section = root.section("hub", keys::keys_of(keys::kHubRows));
  Hub hub;
  keys::read(section, keys::kHubRows, &hub);
  hub.drive = read_drive(section);
  return hub;
}

/// Reads a blade; keys that `own` lacks are taken from `common`. Its azimuth is `azimuth` if not
/// given.
Blade read_blade(const TomlSection& own, const TomlSection& common, double azimuth,
                 const Rotor& rotor) {
  const auto from = [&](std::string_view key) -> const TomlSection& {
    return !own.has(key) && common.has(key) ? common : own;
  };
  Blade blade;
  blade.azimuth = azimuth;
  const TomlSection& material = material_of(own, common);
  if (material.has("sections")) blade.sections = read_sections(material);
  for (const keys::Row& row : keys::kBladeRows) {
    const bool is_own = row.key == "azimuth" || (&material == &own && is_material(row.key));
    keys::read_row(is_own ? own : from(row.key), row, &blade);
  }
  if (material.has("sections")) check_sections(material, blade);
  blade.point_masses = read_point_masses(from("point_mass"), blade);
  if (const char* fault = find_strain_fault(blade.strain, blade.geometric_stiffening))
    from("geometric_stiffening").fail("geometric_stiffening", fault);
  blade.loops = read_loops(from("loop"), surroundings_of(blade, rotor.hub, rotor.anchors));
  return blade;
}

void check_stations(const TomlSection& root, std::size_t count) {
  const std::string fault = find_station_fault(count);
  if (!fault.empty()) root.fail(root.has("blades") ? "blades" : "blade", fault);
}

void check_elements(const TomlSection& root, const std::vector<Blade>& blades) {
  const std::string fault = find_element_fault(blades);
  if (!fault.empty()) root.fail(root.has("blades") ? "blades" : "blade", fault);
}

std::vector<Blade> read_blades(const TomlSection& root, const Rotor& rotor) {
  const TomlSection::Keys keys = keys::keys_of(keys::kBladeRows);
  const TomlSection::Keys common_keys = keys::keys_of(keys::kBladeRows, keys::kBladeCountRows);
  const TomlSection common = root.section("blade", common_keys);
  const std::vector<TomlSection> one_by_one = root.sections("blades", keys);
  const double first = common.number("azimuth", Quantity::any("rad"), 0.0);
  std::vector<Blade> blades;
  if (one_by_one.empty()) {
    if (!root.has("blade") && moves_alone(rotor.hub)) return blades;
    if (!root.has("blade")) root.fail("blade", "is missing, expected [blade] or [[blades]]");
    const int count = common.integer("count", {1, kMostOfAKind});
    const Blade blade = read_blade(common, common, first, rotor);
    check_stations(root, static_cast<std::size_t>(count) * count_stations(blade));
    blades.assign(static_cast<std::size_t>(count), blade);
    for (int i = 0; i < count; ++i) {
      blades[static_cast<std::size_t>(i)].azimuth = first + 2.0 * pi * i / count;
    }
  } else {
    if (common.has("count")) {
      common.fail("count", "given along with [[blades]], expected only one of them");
    }
    const auto count = static_cast<double>(one_by_one.size());
    std::size_t stations = 0;
    for (const TomlSection& own : one_by_one) {
      const double even = first + 2.0 * pi * static_cast<double>(blades.size()) / count;
      blades.push_back(read_blade(own, common, even, rotor));
      check_stations(root, stations += count_stations(blades.back()));
    }
  }
  check_elements(root, blades);
  return blades;
}

}  // namespace

Rotor read_rotor(const TomlSection& root) {
  Rotor rotor;
  rotor.hub = read_hub(root);
  rotor.anchors = read_anchors(root, find_mount_fault(rotor.hub.support), {});
  rotor.blades = read_blades(root, rotor);
  const TomlSection gravity = root.section("gravity", keys::keys_of(keys::kGravityRows));
  if (gravity.has("acceleration")) {
    const std::vector<double> acceleration = gravity.numbers("acceleration", kGravity, kPosition);
    rotor.gravity = Position::Map(acceleration.data());
  }
  keys::read(gravity, keys::kGravityRows, &rotor);
  rotor.damping = read_damping(root, DampedBeams(rotor.blades));
  const std::string fault = find_mass_factor_fault(rotor.damping, rotor.blades);
  if (!fault.empty()) root.fail_at("damping.mass_factor", fault);
  read_loads(root, rotor);
  return rotor;
}

}  // namespace spoke
