// Reads each table of the rotor: hub, drive, blades, loads, gravity, damping.

#include "models/reader/scenario_rotor.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "models/reader/blade_sections.h"
#include "models/reader/field_reader.h"
#include "models/scenario.h"

namespace spoke {
namespace {

using std::numbers::pi;

/// A function of time given as two arrays, or as one number.
Curve read_curve(const TomlSection& section, std::string_view key, const Quantity& quantity) {
  const std::vector<double> times = section.increasing_numbers("time", kTime);
  const std::vector<double> values = section.numbers(key, quantity);
  if (values.size() != times.size()) {
    section.fail(key, "has " + std::to_string(values.size()) + " numbers, expected " +
                          std::to_string(times.size()) + ", one for each of " + section.path() +
                          ".time");
  }
  return {times, values};
}

Curve read_torque(const TomlSection& drive) {
  if (drive.has("time")) return read_curve(drive, "torque", kTorque);
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
  const std::vector<Key> keys = {{"speed", {"spin_up", "spin_up_hold_spin_down", "table"}},
                                 {"ramp", {"spin_up", "spin_up_hold_spin_down"}},
                                 {"hold", {"spin_up_hold_spin_down"}},
                                 {"ramp_down", {"spin_up_hold_spin_down"}},
                                 {"torque", {"torque"}},
                                 {"time", {"torque", "table"}},
                                 {"initial_speed", {"torque", "free"}}};
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
  visit_fields(fields, FieldReader{section});
  return fields;
}

Drive read_drive(const TomlSection& hub) {
  const TomlSection drive = hub.section(
      "drive", {"kind", "speed", "ramp", "hold", "ramp_down", "torque", "time", "initial_speed"});
  const TomlSection::Keys kinds = {"spin_up", "spin_up_hold_spin_down", "torque", "free", "table"};
  const std::string_view kind = kinds[drive.choice("kind", kinds)];
  check_drive_keys(drive, kind);
  if (kind == "table") return SpeedTable{read_curve(drive, "speed", kSpeed)};
  if (kind == "free") return read_fields<FreeDrive>(drive);
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

Hub read_hub(const TomlSection& root) {
  const TomlSection section =
      root.section("hub", {"support", "radius", "inertia", "mass", "drive"});
  Hub hub;
  hub.support = section.choice("support", {HubSupport::axle, HubSupport::free}, hub.support);
  visit_fields(hub, FieldReader{section});
  hub.drive = read_drive(section);
  return hub;
}

/// Reads a blade whose missing keys are those of `common`; its azimuth is `azimuth` if not given.
Blade read_blade(const TomlSection& own, const TomlSection& common, double azimuth) {
  const auto from = [&](std::string_view key) -> const TomlSection& {
    return !own.has(key) && common.has(key) ? common : own;
  };
  Blade blade;
  blade.azimuth = azimuth;
  const TomlSection& material = material_of(own, common);
  if (material.has("sections")) blade.sections = read_sections(material);
  visit_fields(blade, [&](std::string_view key, auto& value, const auto& range, Presence presence) {
    const bool is_own = key == "azimuth" || (&material == &own && is_material(key));
    FieldReader{is_own ? own : from(key)}(key, value, range, presence);
  });
  if (material.has("sections")) check_sections(material, blade);
  blade.point_masses = read_point_masses(from("point_mass"), blade);
  blade.geometric_stiffening =
      from("geometric_stiffening").flag("geometric_stiffening", blade.geometric_stiffening);
  blade.reference_frame =
      from("reference_frame")
          .choice("reference_frame", {ReferenceFrame::clamped, ReferenceFrame::chord},
                  blade.reference_frame);
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

std::vector<Blade> read_blades(const TomlSection& root) {
  const TomlSection::Keys keys = {"length",
                                  "bodies",
                                  "elements",
                                  "density",
                                  "area",
                                  "second_moment",
                                  "youngs_modulus",
                                  "geometric_stiffening",
                                  "reference_frame",
                                  "azimuth",
                                  "sections",
                                  "point_mass"};
  TomlSection::Keys common_keys = keys;
  common_keys.push_back("count");
  const TomlSection common = root.section("blade", common_keys);
  const std::vector<TomlSection> one_by_one = root.sections("blades", keys);
  const double first = common.number("azimuth", Quantity::any("rad"), 0.0);
  std::vector<Blade> blades;
  if (one_by_one.empty()) {
    if (!root.has("blade")) root.fail("blade", "is missing, expected [blade] or [[blades]]");
    const int count = common.integer("count", {1, kMostOfAKind});
    const Blade blade = read_blade(common, common, first);
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
      blades.push_back(read_blade(own, common, even));
      check_stations(root, stations += count_stations(blades.back()));
    }
  }
  check_elements(root, blades);
  return blades;
}

/// The blade a load acts on: its index from 0, or -1 for every blade.
int read_loaded_blade(const TomlSection& section, std::size_t blades) {
  if (!section.has("blade")) return -1;
  if (section.is_text("blade")) {
    section.choice("blade", {"all"});
    return -1;
  }
  return section.integer("blade", {1, static_cast<int>(blades)}) - 1;
}

PointLoad read_load(const TomlSection& section, const std::vector<Blade>& blades) {
  if (!section.has("force") && !section.has("moment")) {
    section.fail("", "has neither force nor moment, expected force = [x, y] or moment = M");
  }
  PointLoad load;
  load.blade = read_loaded_blade(section, blades.size());
  load.frame = section.choice("frame", {LoadFrame::inertial, LoadFrame::hub, LoadFrame::section},
                              load.frame);
  if (section.has("force")) {
    const std::vector<double> force = section.numbers("force", kForce, kPosition);
    load.force = Position::Map(force.data());
  }
  visit_fields(load, FieldReader{section});
  if (section.has("time") || section.has("factor")) {
    load.factor = read_curve(section, "factor", kFactor);
  }
  return load;
}

/// Appends the load to `loads`, at its place: the given one, or the tip of every loaded blade.
void place_load(const TomlSection& section, const std::vector<Blade>& blades, PointLoad load,
                std::vector<PointLoad>& loads) {
  const Blade& shortest = shortest_loaded(load, blades);
  load.position = section.number("position", place_on(shortest), shortest.length);
  const bool is_alike = load.blade >= 0 || section.has("position") ||
                        std::all_of(blades.begin(), blades.end(), [&](const Blade& blade) {
                          return blade.length == shortest.length;
                        });
  if (is_alike) {
    loads.push_back(std::move(load));
    return;
  }
  for (std::size_t i = 0; i < blades.size(); ++i) {
    load.blade = static_cast<int>(i);
    load.position = blades[i].length;
    loads.push_back(load);
  }
}

std::vector<PointLoad> read_loads(const TomlSection& root, const std::vector<Blade>& blades) {
  std::vector<PointLoad> loads;
  std::size_t points = 0;
  for (const TomlSection& section :
       root.sections("load", {"blade", "position", "frame", "force", "moment", "time", "factor"})) {
    PointLoad load = read_load(section, blades);
    // A load on every blade is copied to each.
    points += count_points(load, blades);
    const std::string fault = find_point_fault(points);
    if (!fault.empty()) section.fail("", fault);
    place_load(section, blades, std::move(load), loads);
  }
  return loads;
}

}  // namespace

Rotor read_rotor(const TomlSection& root) {
  Rotor rotor;
  rotor.hub = read_hub(root);
  rotor.blades = read_blades(root);
  const TomlSection gravity = root.section("gravity", {"acceleration"});
  if (gravity.has("acceleration")) {
    const std::vector<double> acceleration = gravity.numbers("acceleration", kGravity, kPosition);
    rotor.gravity = Position::Map(acceleration.data());
  }
  visit_fields(rotor.damping,
               FieldReader{root.section("damping", {"mass_factor", "stiffness_factor"})});
  rotor.loads = read_loads(root, rotor.blades);
  return rotor;
}

}  // namespace spoke
