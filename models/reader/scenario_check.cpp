// Visits every number of a scenario, and words what is wrong.

#include "models/reader/scenario_check.h"

#include <cmath>
#include <sstream>
#include <string>
#include <variant>

#include "models/reader/damping.h"
#include "models/reader/loop_faults.h"
#include "models/reader/names.h"
#include "models/reader/scenario_fields.h"
#include "models/reader/scenario_sensors.h"
#include "models/reader/spatial/model_check.h"
#include "models/reader/spatial/sensor_reader.h"
#include "models/reader/spatial/wind_reader.h"
#include "models/reader/statistics_reader.h"
#include "models/start.h"
#include "spoke/error.h"

namespace spoke {
namespace {

[[noreturn]] void fail(const std::string& key, const std::string& what) {
  throw InputError(key + ": " + what, {.key = key});
}

void check(const std::string& key, double value, const Quantity& quantity) {
  const std::string expected = quantity.expectation_instead_of(value);
  if (!expected.empty()) fail(key, "is " + describe(value) + ", expected " + expected);
}

void check(const std::string& key, int value, const Count& count) {
  if (!count.holds(value))
    fail(key, "is " + std::to_string(value) + ", expected " + count.expectation());
}

template <class Fields>
void check_fields(const std::string& path, const Fields& fields) {
  visit_fields(fields, [&](std::string_view key, const auto& value, const auto& range, Presence) {
    check(path + '.' + std::string(key), value, range);
  });
}

template <class Numbers>
void check_numbers(const std::string& key, const Numbers& numbers, const Quantity& quantity) {
  int index = 0;
  for (const double value : numbers) check(key + '.' + std::to_string(++index), value, quantity);
}

/// Checks a curve's values; it is finite and its times increase anyway.
void check_curve(const std::string& path, const char* key, const Curve& curve,
                 const Quantity& quantity) {
  check_numbers(path + ".time", curve.times(), kTime);
  check_numbers(path + '.' + key, curve.values(), quantity);
}

void check_sections(const std::string& path, const Blade& blade) {
  const auto check_unused = [&](const char* key, double value) {
    if (value != 0.0)
      fail(path + '.' + key, "given along with sections, expected only one of them");
  };
  check_unused("density", blade.density);
  check_unused("area", blade.area);
  check_unused("second_moment", blade.second_moment);
  check_unused("youngs_modulus", blade.youngs_modulus);
  check_numbers(path + ".sections.station", blade.sections.station, kStation);
  visit_properties(blade.sections, [&](std::string_view key, const std::vector<double>& values,
                                       const Quantity& quantity) {
    check_numbers(path + ".sections." + std::string(key), values, quantity);
  });
  const SectionsFault fault = find_sections_fault(blade);
  if (!fault.key.empty()) fail(path + ".sections." + fault.key, fault.text);
}

void check_blade(const std::string& path, const Blade& blade) {
  check_fields(path, blade);
  if (has_sections(blade)) check_sections(path, blade);
  if (const char* fault = find_strain_fault(blade.strain, blade.geometric_stiffening))
    fail(path + ".geometric_stiffening", fault);
  const std::size_t masses = blade.point_masses.size();
  if (masses > kMostPointMasses)
    fail(path + ".point_mass", "are " + std::to_string(masses) + " tables, expected at most " +
                                   std::to_string(kMostPointMasses));
  std::size_t number = 0;
  for (const PointMass& point : blade.point_masses) {
    const std::string point_path = path + ".point_mass." + std::to_string(++number);
    check(point_path + ".position", point.position, place_on(blade));
    check_fields(point_path, point);
  }
}

void check_loops(const Rotor& rotor) {
  const auto require = [](const std::string& path, const Fault& fault) {
    if (fault) fail(fault.within(path).path, fault.text);
  };
  std::vector<Anchor> anchors;
  for (const Anchor& anchor : rotor.anchors) {
    require("anchor." + std::to_string(anchors.size() + 1),
            find_fault(anchor, anchors, find_mount_fault(rotor.hub.support), true));
    anchors.push_back(anchor);
  }
  std::size_t number = 0;
  for (const Blade& blade : rotor.blades)
    require("blades." + std::to_string(++number),
            find_fault(blade.loops, surroundings_of(blade, rotor.hub, rotor.anchors)));
}

void check_blades(const std::vector<Blade>& blades, const Hub& hub) {
  if (blades.empty() && !moves_alone(hub)) fail("blades", "there are none, expected one or more");
  std::size_t number = 0, stations = 0;
  for (const Blade& blade : blades) {
    check_blade("blades." + std::to_string(++number), blade);
    stations += count_stations(blade);
  }
  const std::string station_fault = find_station_fault(stations);
  if (!station_fault.empty()) fail("blades", station_fault);
  const std::string fault = find_element_fault(blades);
  if (!fault.empty()) fail("blades", fault);
}

void check_blade(const std::string& path, BladeChoice loaded, const std::vector<Blade>& blades) {
  if (!loaded.is_all())
    check(path + ".blade", loaded.number(), Count{1, static_cast<int>(blades.size())});
}

void check_position(const std::string& path, const std::optional<double>& position,
                    BladeChoice loaded, const std::vector<Blade>& blades) {
  if (position) check(path + ".position", *position, place_on(shortest_loaded(loaded, blades)));
}

template <class Load>
void check_ends(const std::string& path, const Load& load, const std::vector<Blade>& blades) {
  const Blade& shortest = shortest_loaded(load.blade, blades);
  check(path + ".from", load.from, place_on(shortest));
  if (load.to) check(path + ".to", *load.to, end_on(shortest, load.from));
  if (load.from >= load.to.value_or(shortest.length))
    fail(path + ".from", "is " + describe(load.from) + ", expected less than the blade's length, " +
                             describe(shortest.length) + " (m)");
}

void check_load(const std::string& path, const PointLoad& load, const std::vector<Blade>& blades) {
  check_blade(path, load.blade, blades);
  check_position(path, load.position, load.blade, blades);
  check_numbers(path + ".force", load.force, kForce);
}

void check_load(const std::string& path, const DistributedLoad& load,
                const std::vector<Blade>& blades) {
  check_blade(path, load.blade, blades);
  check_ends(path, load, blades);
  check_numbers(path + ".force_per_length", load.force_per_length, kForcePerLength);
}

void check_load(const std::string& path, const Drag& drag, const std::vector<Blade>& blades) {
  check_blade(path, drag.blade, blades);
  check_position(path, drag.position, drag.blade, blades);
  check_ends(path, drag, blades);
}

void check_load(const std::string& path, const HubLoad& load, const std::vector<Blade>&) {
  check_numbers(path + ".position", load.position, kLength);
  if (load.frame == LoadFrame::section)
    fail(path + ".frame", "is \"section\", expected \"hub\" or \"inertial\"");
  check_numbers(path + ".force", load.force, kForce);
}

/// Checks the loads of one kind; `visit` is called with the path of each and the load.
template <class Load, class Visit>
void check_loads(const char* table, const std::vector<Load>& loads,
                 const std::vector<Blade>& blades, const Visit& visit) {
  std::size_t number = 0;
  if (!std::is_same_v<Load, HubLoad> && !loads.empty() && blades.empty()) fail(table, kNoBlades);
  for (const Load& load : loads) {
    const std::string path = table + ('.' + std::to_string(++number));
    check_load(path, load, blades);
    check_fields(path, load);
    check_curve(path, "factor", load.factor, kFactor);
    if (const std::string fault = find_load_name_fault(load.name); !fault.empty())
      fail(path + ".name", fault);
    visit(path, load);
  }
}

void check_all_loads(const Rotor& rotor) {
  std::size_t points = 0;
  const auto count = [&](const std::string& path, const auto& load, bool is_per_length) {
    points += count_points(load.blade, is_per_length, load.factor, rotor.blades);
    const std::string fault = find_point_fault(points);
    if (!fault.empty()) fail(path, fault);
  };
  using Path = const std::string&;
  check_loads("load", rotor.loads, rotor.blades,
              [&](Path path, const PointLoad& load) { count(path, load, false); });
  check_loads("distributed_load", rotor.distributed_loads, rotor.blades,
              [&](Path path, const DistributedLoad& load) { count(path, load, true); });
  check_loads("drag", rotor.drags, rotor.blades,
              [&](Path path, const Drag& drag) { count(path, drag, is_distributed(drag)); });
  check_loads("hub_load", rotor.hub_loads, rotor.blades, [](Path, const HubLoad&) {});
}

void check_rotor(const Rotor& rotor) {
  check_fields("hub", rotor.hub);
  check_drive(rotor.hub.drive);
  check_blades(rotor.blades, rotor.hub);
  check_loops(rotor);
  check_numbers("gravity.acceleration", rotor.gravity, kGravity);
  check("gravity.ramp", rotor.gravity_ramp, kRamp);
  check_fields("damping", rotor.damping);
  const DampingFault beams_fault = find_damping_fault(rotor.damping, DampedBeams(rotor.blades));
  if (!beams_fault.text.empty()) fail("damping." + beams_fault.key, beams_fault.text);
  const std::string damping_fault = find_mass_factor_fault(rotor.damping, rotor.blades);
  if (!damping_fault.empty()) fail("damping.mass_factor", damping_fault);
  check_all_loads(rotor);
}

}  // namespace

void check_drive(const Drive& drive) {
  const std::string path = "hub.drive";
  if (const auto* table = std::get_if<SpeedTable>(&drive))
    return check_curve(path, "speed", table->speed, kSpeed);
  if (const auto* torque = std::get_if<TorqueDrive>(&drive))
    check_curve(path, "torque", torque->torque, kTorque);
  if (const auto* by_speed = std::get_if<TorqueBySpeed>(&drive)) {
    check_numbers(path + ".speed", by_speed->torque.times(), kSpeed);
    check_numbers(path + ".torque", by_speed->torque.values(), kTorque);
  }
  std::visit(
      [&](const auto& fields) {
        using Fields = std::decay_t<decltype(fields)>;
        if constexpr (!std::is_same_v<Fields, SpeedTable> && !std::is_same_v<Fields, FixedDrive>)
          check_fields(path, fields);
      },
      drive);
}

void check_continuation(const Drive& before, const Drive& after, double t) {
  if (prescribes_motion(before) != prescribes_motion(after))
    throw InputError("a drive " + std::string(name_of(after)) + " cannot take over from " +
                     std::string(name_of(before)) +
                     ": expected one that prescribes the hub's rotation as well, or one that does "
                     "not as well");
  if (!prescribes_motion(after)) return;
  const DriveMotion old = calc_motion(before, t), next = calc_motion(after, t);
  constexpr double slack = 1e-9;
  if (std::abs(old.angle - next.angle) <= slack && std::abs(old.speed - next.speed) <= slack)
    return;
  std::ostringstream text;
  text << "the drive " << name_of(after) << " does not go on from where the hub is at t = " << t
       << " s: it begins at " << next.angle << " rad and " << next.speed << " rad/s, expected "
       << old.angle << " rad and " << old.speed << " rad/s";
  throw InputError(text.str());
}

void check_scenario(const Scenario& scenario) {
  if (scenario.space) {
    check_drive(scenario.space->hub.drive);
    spatial::check_model(*scenario.space);
    if (!scenario.rotor.blades.empty())
      fail("blades", "there are some of the plane in a model in space, expected none");
  } else {
    check_rotor(scenario.rotor);
  }
  if (scenario.initial.speed) check("initial.speed", *scenario.initial.speed, kSpeed);
  const StartFault start = find_start_fault(scenario);
  if (!start.key.empty()) fail("initial." + start.key, start.text);
  check_fields("integration", scenario.integration);
  const std::string fault = find_step_fault(scenario.integration);
  if (!fault.empty()) fail("integration.step", fault);
  const std::string radius_fault = find_radius_fault(scenario.integration, scenario);
  if (!radius_fault.empty()) fail("integration.spectral_radius", radius_fault);
  if (const spatial::Fault end = spatial::find_end_fault(scenario)) fail(end.path, end.text);
  check_fields("limits", scenario.limits);
  check_fields("output", scenario.output);
  check_statistics(scenario);
  if (scenario.space)
    spatial::check_sensors(scenario.sensors, *scenario.space);
  else
    check_sensors(scenario.sensors, scenario.rotor.blades);
}

}  // namespace spoke
