// A scenario that is filled in code is refused for the faults for which a file is.

#include "models/reader/scenario_check.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/message_of.h"

using namespace spoke;
using spoke::test::message_of;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scenario make_scenario() {
  Blade blade;
  blade.length = 8.0;
  blade.density = 2766.67;
  blade.area = 7.299e-5;
  blade.second_moment = 8.214e-9;
  blade.youngs_modulus = 6.895e10;
  Scenario scenario;
  scenario.rotor.blades = {blade, blade};
  scenario.rotor.blades[1].length = 6.0;
  scenario.rotor.hub.drive = SpinUp{4.0, 15.0};
  scenario.rotor.loads.push_back(
      {.blade = BladeChoice::number(2), .position = 6.0, .force = {0.0, 1.0}});
  scenario.integration.duration = 20.0;
  return scenario;
}

/// Returns the message for a sound scenario that was changed.
std::string message_after(const std::function<void(Scenario&)>& change) {
  Scenario scenario = make_scenario();
  change(scenario);
  return message_of([&] { check_scenario(scenario); });
}

struct Case {
  std::function<void(Scenario&)> change;
  std::string message;
};

void check_cases(const std::vector<Case>& cases) {
  for (const Case& c : cases) CHECK(message_after(c.change) == c.message);
}

Blade& second(Scenario& s) { return s.rotor.blades[1]; }

}  // namespace

TEST_CASE("a sound scenario passes") {
  CHECK(message_after([](Scenario&) {}) == "no error");
  CHECK(message_after([](Scenario& s) { s.rotor.loads[0].blade = BladeChoice::all(); }) ==
        "no error");
}

TEST_CASE("blades in code are checked as those of a file") {
  check_cases({
      {[](Scenario& s) { s.rotor.blades.clear(); }, "blades: there are none, expected one or more"},
      {[](Scenario& s) { second(s).length = -8.0; },
       "blades.2.length: is -8, expected a number greater than 0 (m)"},
      {[](Scenario& s) { second(s).length = kNan; },
       "blades.2.length: is nan, expected a finite number (m)"},
      {[](Scenario& s) { second(s).bodies = 0; },
       "blades.2.bodies: is 0, expected a whole number from 1 to 100000"},
      {[](Scenario& s) { second(s).elements = 0; },
       "blades.2.elements: is 0, expected a whole number from 1 to 100000"},
      {[](Scenario& s) { second(s).density = 0.0; },
       "blades.2.density: is 0, expected a number greater than 0 (kg/m^3)"},
      {[](Scenario& s) { second(s).area = -0.25; },
       "blades.2.area: is -0.25, expected a number greater than 0 (m^2)"},
      {[](Scenario& s) { second(s).second_moment = 0.0; },
       "blades.2.second_moment: is 0, expected a number greater than 0 (m^4)"},
      {[](Scenario& s) { second(s).youngs_modulus = 1e31; },
       "blades.2.youngs_modulus: is 1e+31, expected 0 or a magnitude from 1e-40 to 1e+30 (Pa)"},
      {[](Scenario& s) { second(s).azimuth = kInfinity; },
       "blades.2.azimuth: is inf, expected a finite number (rad)"},
      {[](Scenario& s) { second(s).bodies = second(s).elements = 10'000; },
       "blades: makes 100000016 elements (blades x bodies x elements), expected at most 20000000"},
  });
}

TEST_CASE("hub, drive, gravity and damping in code are checked as those of a file") {
  check_cases({
      {[](Scenario& s) { s.rotor.hub.radius = -0.1; },
       "hub.radius: is -0.1, expected a number of 0 or more (m)"},
      {[](Scenario& s) { s.rotor.hub.inertia = 0.0; },
       "hub.inertia: is 0, expected a number greater than 0 (kg m^2)"},
      {[](Scenario& s) { s.rotor.hub.mass = -1.0; },
       "hub.mass: is -1, expected a number of 0 or more (kg)"},
      {[](Scenario& s) { s.rotor.hub.support = HubSupport::free; },
       "hub.mass: is 0, expected a number greater than 0 (kg)"},
      {[](Scenario& s) {
         s.rotor.hub.drive = SpinUp{4.0, 0.0};
       },
       "hub.drive.ramp: is 0, expected a number greater than 0 (s)"},
      {[](Scenario& s) {
         s.rotor.hub.drive = SpinUpHoldSpinDown{4.0, 1.0, -1.0, 1.0};
       },
       "hub.drive.hold: is -1, expected a number of 0 or more (s)"},
      {[](Scenario& s) {
         s.rotor.hub.drive = SpeedTable{Curve({0.0, 1.0}, {0.0, 1e31})};
       },
       "hub.drive.speed.2: is 1e+31, expected 0 or a magnitude from 1e-40 to 1e+30 (rad/s)"},
      {[](Scenario& s) {
         s.rotor.hub.drive = TorqueDrive{Curve(1e31), 0.0};
       },
       "hub.drive.torque.1: is 1e+31, expected 0 or a magnitude from 1e-40 to 1e+30 (N m)"},
      {[](Scenario& s) {
         s.rotor.hub.drive = TorqueDrive{Curve(1.0), kNan};
       },
       "hub.drive.initial_speed: is nan, expected a finite number (rad/s)"},
      {[](Scenario& s) { s.rotor.hub.drive = FreeDrive{kNan}; },
       "hub.drive.initial_speed: is nan, expected a finite number (rad/s)"},
      {[](Scenario& s) {
         s.rotor.gravity = {0.0, kNan};
       },
       "gravity.acceleration.2: is nan, expected a finite number (m/s^2)"},
      {[](Scenario& s) { s.rotor.damping.mass_factor = -1.0; },
       "damping.mass_factor: is -1, expected a number of 0 or more (1/s)"},
      {[](Scenario& s) {
         s.rotor.damping.mass_factor = 0.1;
         s.rotor.blades[0].bodies = 2;
       },
       "damping.mass_factor: damps motion relative to each body's own frame, next to none of a "
       "blade of several bodies; expected 0, or bodies = 1: stiffness_factor damps any number of "
       "bodies alike, [[drag]] relative to the hub the motion in the hub's frame"},
  });
}

TEST_CASE("loads in code are checked as those of a file") {
  // An index, from 0, is no number of a blade, from 1.
  static_assert(!std::is_constructible_v<BladeChoice, int>);
  check_cases({
      {[](Scenario& s) { s.rotor.loads[0].blade = BladeChoice::number(3); },
       "load.1.blade: is 3, expected a whole number from 1 to 2"},
      {[](Scenario& s) { s.rotor.loads[0].blade = BladeChoice::number(0); },
       "load.1.blade: is 0, expected a whole number from 1 to 2"},
      {[](Scenario& s) { s.rotor.loads[0].blade = BladeChoice::number(-1); },
       "load.1.blade: is -1, expected a whole number from 1 to 2"},
      {[](Scenario& s) { s.rotor.loads[0].position = 6.5; },
       "load.1.position: is 6.5, expected a number from 0 to 6 (m, from root to tip of the blade)"},
      {[](Scenario& s) {
         s.rotor.loads[0].blade = BladeChoice::all();
         s.rotor.loads[0].position = 7.0;
       },
       "load.1.position: is 7, expected a number from 0 to 6 (m, from root to tip of the blade)"},
      {[](Scenario& s) {
         s.rotor.loads[0].force = {kNan, 0.0};
       },
       "load.1.force.1: is nan, expected a finite number (N)"},
      {[](Scenario& s) { s.rotor.loads[0].moment = kInfinity; },
       "load.1.moment: is inf, expected a finite number (N m)"},
      {[](Scenario& s) {
         s.rotor.loads[0].factor = Curve({0.0, 1e31}, {0.0, 1.0});
       },
       "load.1.time.2: is 1e+31, expected 0 or a magnitude from 1e-40 to 1e+30 (s)"},
      {[](Scenario& s) {
         std::vector<double> times(1'000'001);
         for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<double>(k);
         s.rotor.loads[0].position = 0.0;
         s.rotor.loads[0].blade = BladeChoice::all();
         s.rotor.loads[0].factor = Curve(times, times);
       },
       "load.1: makes 2000002 points (loads x blades x times) with those before it, expected at "
       "most 2000000"},
  });
}

TEST_CASE(
    "loads along blades and on the hub, drag and ramps in code are checked as those of a file") {
  check_cases({
      {[](Scenario& s) { s.rotor.gravity_ramp = -1.0; },
       "gravity.ramp: is -1, expected a number of 0 or more (s)"},
      {[](Scenario& s) { s.rotor.loads[0].ramp = kNan; },
       "load.1.ramp: is nan, expected a finite number (s)"},
      {[](Scenario& s) { s.rotor.distributed_loads.push_back({.blade = BladeChoice::number(3)}); },
       "distributed_load.1.blade: is 3, expected a whole number from 1 to 2"},
      {[](Scenario& s) { s.rotor.distributed_loads.push_back({.from = 6.0}); },
       "distributed_load.1.from: is 6, expected less than the blade's length, 6 (m)"},
      {[](Scenario& s) { s.rotor.distributed_loads.push_back({.from = 2.0, .to = 1.0}); },
       "distributed_load.1.to: is 1, expected a number greater than 2 and at most 6 (m, beyond "
       "from, up to the blade's tip)"},
      {[](Scenario& s) {
         s.rotor.distributed_loads.push_back({.force_per_length = {0.0, kNan}});
       },
       "distributed_load.1.force_per_length.2: is nan, expected a finite number (N/m)"},
      {[](Scenario& s) { s.rotor.drags.push_back({.linear = -1.0}); },
       "drag.1.linear: is -1, expected a number of 0 or more (N s/m)"},
      {[](Scenario& s) { s.rotor.drags.push_back({.position = 7.0, .linear = 1.0}); },
       "drag.1.position: is 7, expected a number from 0 to 6 (m, from root to tip of the blade)"},
      {[](Scenario& s) { s.rotor.drags.push_back({.to = kInfinity, .linear_per_length = 1.0}); },
       "drag.1.to: is inf, expected a finite number (m, beyond from, up to the blade's tip)"},
      {[](Scenario& s) { s.rotor.hub_loads.push_back({.frame = LoadFrame::section}); },
       "hub_load.1.frame: is \"section\", expected \"hub\" or \"inertial\""},
      {[](Scenario& s) {
         s.rotor.hub_loads.push_back({.position = {kNan, 0.0}});
       },
       "hub_load.1.position.1: is nan, expected a finite number (m)"},
      {[](Scenario& s) { s.rotor.hub_loads.push_back({.torque = kInfinity}); },
       "hub_load.1.torque: is inf, expected a finite number (N m)"},
      {[](Scenario& s) { s.rotor.hub.drive = ConstantSpeed{kNan}; },
       "hub.drive.speed: is nan, expected a finite number (rad/s)"},
      {[](Scenario& s) {
         s.rotor.hub.drive = TorqueBySpeed{Curve({0.0, 1e31}, {1.0, 2.0}), 0.0, 0.0};
       },
       "hub.drive.speed.2: is 1e+31, expected 0 or a magnitude from 1e-40 to 1e+30 (rad/s)"},
  });
}

TEST_CASE("integration, limits and output in code are checked as those of a file") {
  check_cases({
      {[](Scenario& s) { s.integration.step = 0.0; },
       "integration.step: is 0, expected a number greater than 0 (s)"},
      {[](Scenario& s) { s.integration.step = 30.0; },
       "integration.step: the step is 30 s, expected at most the duration, 20 s"},
      {[](Scenario& s) { s.integration.step = 1e-12; },
       "integration.step: makes 2e+13 steps, expected at most 1e+10"},
      {[](Scenario& s) { s.integration.duration = kNan; },
       "integration.duration: is nan, expected a finite number (s)"},
      {[](Scenario& s) { s.integration.spectral_radius = 1.5; },
       "integration.spectral_radius: is 1.5, expected a number from 0 to 1"},
      {[](Scenario& s) { s.integration.tolerance = -1.0; },
       "integration.tolerance: is -1, expected a number greater than 0 (m, rad)"},
      {[](Scenario& s) { s.integration.iterations = -1; },
       "integration.iterations: is -1, expected a whole number from 0 to 1000"},
      {[](Scenario& s) { s.integration.max_iterations = 0; },
       "integration.max_iterations: is 0, expected a whole number from 1 to 1000"},
      {[](Scenario& s) { s.limits.deflection = -0.1; },
       "limits.deflection: is -0.1, expected a number of 0 or more"},
      {[](Scenario& s) { s.limits.energy_growth = kNan; },
       "limits.energy_growth: is nan, expected a finite number"},
      {[](Scenario& s) { s.output.interval = -1.0; },
       "output.interval: is -1, expected a number of 0 or more (s)"},
  });
}
