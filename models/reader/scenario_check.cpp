// Visits every number of a scenario, and words what is wrong.

#include "models/reader/scenario_check.h"

#include <cmath>
#include <sstream>
#include <string>
#include <variant>

#include "models/reader/scenario_fields.h"
#include "models/reader/scenario_sensors.h"
#include "spoke/error.h"

namespace spoke {
namespace {

[[noreturn]] void fail(const std::string& key, const std::string& what) {
  throw InputError(key + ": " + what);
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
  visit_fields(fields, [&](const char* key, const auto& value, const auto& range, Presence) {
    check(path + '.' + key, value, range);
  });
}

template <class Numbers>
void check_numbers(const std::string& key, const Numbers& numbers, const Quantity& quantity) {
  int index = 0;
  for (const double value : numbers) check(key + '.' + std::to_string(++index), value, quantity);
}

/// A curve is finite and its times increase: it would not exist else.
void check_curve(const std::string& path, const char* key, const Curve& curve,
                 const Quantity& quantity) {
  check_numbers(path + ".time", curve.times(), kTime);
  check_numbers(path + '.' + key, curve.values(), quantity);
}

void check_blades(const std::vector<Blade>& blades) {
  if (blades.empty()) fail("blades", "there are none, expected one or more");
  std::size_t number = 0;
  for (const Blade& blade : blades) check_fields("blades." + std::to_string(++number), blade);
  const std::string fault = find_element_fault(blades);
  if (!fault.empty()) fail("blades", fault);
}

void check_load(const std::string& path, const PointLoad& load, const std::vector<Blade>& blades) {
  const int last = static_cast<int>(blades.size()) - 1;
  if (load.blade < -1 || load.blade > last)
    fail(path + ".blade", "is index " + std::to_string(load.blade) + ", expected 0 to " +
                              std::to_string(last) + ", or -1 for every blade");
  check(path + ".position", load.position, place_on(shortest_loaded(load, blades)));
  check_numbers(path + ".force", load.force, kForce);
  check_fields(path, load);
  check_curve(path, "factor", load.factor, kFactor);
}

void check_loads(const std::vector<PointLoad>& loads, const std::vector<Blade>& blades) {
  std::size_t number = 0, points = 0;
  for (const PointLoad& load : loads) {
    const std::string path = "load." + std::to_string(++number);
    check_load(path, load, blades);
    points += count_points(load, blades);
    const std::string fault = find_point_fault(points);
    if (!fault.empty()) fail(path, fault);
  }
}

}  // namespace

void check_drive(const Drive& drive) {
  const std::string path = "hub.drive";
  if (const auto* table = std::get_if<SpeedTable>(&drive))
    return check_curve(path, "speed", table->speed, kSpeed);
  if (const auto* torque = std::get_if<TorqueDrive>(&drive))
    check_curve(path, "torque", torque->torque, kTorque);
  std::visit(
      [&](const auto& fields) {
        if constexpr (!std::is_same_v<decltype(fields), const SpeedTable&>)
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
  const Rotor& rotor = scenario.rotor;
  check_fields("hub", rotor.hub);
  check_drive(rotor.hub.drive);
  check_blades(rotor.blades);
  check_numbers("gravity.acceleration", rotor.gravity, kGravity);
  check_fields("damping", rotor.damping);
  check_loads(rotor.loads, rotor.blades);
  check_fields("integration", scenario.integration);
  const std::string fault = find_step_fault(scenario.integration);
  if (!fault.empty()) fail("integration.step", fault);
  check_fields("limits", scenario.limits);
  check_fields("output", scenario.output);
  check_sensors(scenario.sensors, rotor.blades);
}

}  // namespace spoke
