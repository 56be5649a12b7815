#include "models/scenario_rotor.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <utility>

#include "models/scenario.h"

namespace spoke {
namespace {

using std::numbers::pi;

// Sizes beyond these are slips of the keyboard, not machines anybody simulates; below them
// the engine still compares its need with the memory there is.
constexpr int kMostOfAKind = 100'000;
constexpr std::int64_t kMostElements = 20'000'000;
constexpr std::size_t kMostLoadPoints = 2'000'000;

/// A function of time given as two arrays, or as one number.
Curve read_curve(const TomlSection& section, std::string_view key, const Quantity& quantity) {
  const std::vector<double> times = section.increasing_numbers("time", Quantity::any("s"));
  const std::vector<double> values = section.numbers(key, quantity);
  if (values.size() != times.size()) {
    section.fail(key, "has " + std::to_string(values.size()) + " numbers, expected " +
                          std::to_string(times.size()) + ", one for each of " + section.path() +
                          ".time");
  }
  return {times, values};
}

Curve read_torque(const TomlSection& drive) {
  const Quantity torque = Quantity::any("N m");
  if (drive.has("time")) return read_curve(drive, "torque", torque);
  if (drive.is_array("torque")) {
    drive.fail_expected("torque", "a number (N m), or with an array also the array time (s)");
  }
  return Curve(drive.number("torque", torque));
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

Drive read_drive(const TomlSection& hub) {
  const TomlSection drive = hub.section(
      "drive", {"kind", "speed", "ramp", "hold", "ramp_down", "torque", "time", "initial_speed"});
  const TomlSection::Keys kinds = {"spin_up", "spin_up_hold_spin_down", "torque", "free", "table"};
  const std::string_view kind = kinds[drive.choice("kind", kinds)];
  check_drive_keys(drive, kind);
  const Quantity speed = Quantity::any("rad/s");
  if (kind == "table") return SpeedTable{read_curve(drive, "speed", speed)};
  if (kind == "free") return FreeDrive{drive.number("initial_speed", speed, 0.0)};
  if (kind == "torque") {
    return TorqueDrive{read_torque(drive), drive.number("initial_speed", speed, 0.0)};
  }
  const double full_speed = drive.number("speed", speed);
  const double ramp = drive.number("ramp", Quantity::positive("s"));
  if (kind == "spin_up") return SpinUp{full_speed, ramp};
  return SpinUpHoldSpinDown{full_speed, ramp,
                            drive.number("hold", Quantity::not_negative("s"), 0.0),
                            drive.number("ramp_down", Quantity::positive("s"), ramp)};
}

Hub read_hub(const TomlSection& root) {
  const TomlSection section =
      root.section("hub", {"support", "radius", "inertia", "mass", "drive"});
  Hub hub;
  hub.support = section.choice("support", {HubSupport::axle, HubSupport::free}, hub.support);
  hub.radius = section.number("radius", Quantity::not_negative("m"), hub.radius);
  hub.inertia = section.number("inertia", Quantity::positive("kg m^2"), hub.inertia);
  if (hub.support == HubSupport::free) {
    hub.mass = section.number("mass", Quantity::positive("kg"));
  } else {
    hub.mass = section.number("mass", Quantity::not_negative("kg"), hub.mass);
  }
  hub.drive = read_drive(section);
  return hub;
}

/// Reads a blade whose missing keys are those of `common`; its azimuth is `azimuth` if not given.
Blade read_blade(const TomlSection& own, const TomlSection& common, double azimuth) {
  const auto from = [&](std::string_view key) -> const TomlSection& {
    return !own.has(key) && common.has(key) ? common : own;
  };
  const auto positive = [&](std::string_view key, std::string_view unit) {
    return from(key).number(key, Quantity::positive(unit));
  };
  Blade blade;
  blade.length = positive("length", "m");
  blade.bodies = from("bodies").integer("bodies", 1, kMostOfAKind, blade.bodies);
  blade.elements = from("elements").integer("elements", 1, kMostOfAKind, blade.elements);
  blade.density = positive("density", "kg/m^3");
  blade.area = positive("area", "m^2");
  blade.second_moment = positive("second_moment", "m^4");
  blade.youngs_modulus = positive("youngs_modulus", "Pa");
  blade.geometric_stiffening =
      from("geometric_stiffening").flag("geometric_stiffening", blade.geometric_stiffening);
  blade.reference_frame =
      from("reference_frame")
          .choice("reference_frame", {ReferenceFrame::clamped, ReferenceFrame::chord},
                  blade.reference_frame);
  blade.azimuth = own.number("azimuth", Quantity::any("rad"), azimuth);
  return blade;
}

void check_elements(const TomlSection& root, const std::vector<Blade>& blades) {
  std::int64_t elements = 0;
  for (const Blade& blade : blades) elements += std::int64_t{blade.bodies} * blade.elements;
  if (elements <= kMostElements) return;
  root.fail(root.has("blades") ? "blades" : "blade",
            "makes " + std::to_string(elements) + " elements (blades x bodies x elements), " +
                "expected at most " + std::to_string(kMostElements));
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
                                  "azimuth"};
  TomlSection::Keys common_keys = keys;
  common_keys.push_back("count");
  const TomlSection common = root.section("blade", common_keys);
  const std::vector<TomlSection> one_by_one = root.sections("blades", keys);
  const double first = common.number("azimuth", Quantity::any("rad"), 0.0);
  std::vector<Blade> blades;
  if (one_by_one.empty()) {
    if (!root.has("blade")) root.fail("blade", "is missing, expected [blade] or [[blades]]");
    const int count = common.integer("count", 1, kMostOfAKind);
    const Blade blade = read_blade(common, common, first);
    blades.assign(static_cast<std::size_t>(count), blade);
    for (int i = 0; i < count; ++i) {
      blades[static_cast<std::size_t>(i)].azimuth = first + 2.0 * pi * i / count;
    }
  } else {
    if (common.has("count")) {
      common.fail("count", "given along with [[blades]], expected only one of them");
    }
    const auto count = static_cast<double>(one_by_one.size());
    for (const TomlSection& own : one_by_one) {
      const double even = first + 2.0 * pi * static_cast<double>(blades.size()) / count;
      blades.push_back(read_blade(own, common, even));
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
  return section.integer("blade", 1, static_cast<int>(blades)) - 1;
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
    const std::vector<double> force = section.numbers("force", Quantity::any("N"), kPosition);
    load.force = Position::Map(force.data());
  }
  load.moment = section.number("moment", Quantity::any("N m"), load.moment);
  if (section.has("time") || section.has("factor")) {
    load.factor = read_curve(section, "factor", Quantity::any(""));
  }
  return load;
}

/// Appends the load to `loads`, at its place: the given one, or the tip of every loaded blade.
void place_load(const TomlSection& section, const std::vector<Blade>& blades, PointLoad load,
                std::vector<PointLoad>& loads) {
  const auto place_on = [&](const Blade& shortest) {
    load.position = section.number(
        "position", {"m, from root to tip of the blade", 0.0, shortest.length}, shortest.length);
  };
  if (load.blade >= 0) {
    place_on(blades[static_cast<std::size_t>(load.blade)]);
    loads.push_back(std::move(load));
    return;
  }
  const auto shorter = [](const Blade& a, const Blade& b) { return a.length < b.length; };
  const auto [shortest, longest] = std::minmax_element(blades.begin(), blades.end(), shorter);
  place_on(*shortest);
  if (section.has("position") || shortest->length == longest->length) {
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
    points += (load.blade < 0 ? blades.size() : 1) * load.factor.times().size();
    if (points > kMostLoadPoints) {
      section.fail("", "makes " + std::to_string(points) +
                           " points (loads x blades x times) with those before it, expected at " +
                           "most " + std::to_string(kMostLoadPoints));
    }
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
    const std::vector<double> acceleration =
        gravity.numbers("acceleration", Quantity::any("m/s^2"), kPosition);
    rotor.gravity = Position::Map(acceleration.data());
  }
  const TomlSection damping = root.section("damping", {"mass_factor", "stiffness_factor"});
  rotor.damping.mass_factor = damping.number("mass_factor", Quantity::not_negative("1/s"), 0.0);
  rotor.damping.stiffness_factor =
      damping.number("stiffness_factor", Quantity::not_negative("s"), 0.0);
  rotor.loads = read_loads(root, rotor.blades);
  return rotor;
}

}  // namespace spoke
