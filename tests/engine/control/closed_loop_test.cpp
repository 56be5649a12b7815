// Rotors under control of their pitch: the loop is closed by a vane, whose force turns with its
// pitch joint, so that the torque on the hub is -r F sin(theta).

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using doctest::Approx;

namespace {

constexpr double kSetPoint = 2.0;                 // rad/s
constexpr double kInertia = 12.5;                 // kg m^2: 10, 0.5 * 2^2 and 0.5
constexpr double kSlope = 2.0 * 3.0 / kInertia;   // angular acceleration by pitch angle [1/s^2]
constexpr double kFrequency = 1.5, kRatio = 0.6;  // of the loop [rad/s, -]

const std::string kVane = R"(
[[subsystem]]
name = "vane"
[[subsystem.body]]
name = "plate"
kind = "rigid"
mass = 0.5
inertia = 0.5
[[subsystem.joint]]
name = "pitch"
parent = "hub"
child = "plate"
kind = "revolute"
offset = [2.0, 0.0, 0.0]
axis = [1.0, 0.0, 0.0]
motion = { constant = 0.0 }
[[load]]
subsystem = "vane"
body = "plate"
frame = "body"
force = [0.0, 0.0, 3.0]
)";

std::string number(double value) {
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.17g", value)));
  return text;
}

/// Returns the rotor with a torque on it; `more`: further keys of the controller.
std::string make_rotor(double error, double torque, const std::string& more) {
  return "world = \"space\"\n[integration]\nduration = 1.0\n[hub]\ninertia = [8.0, 8.0, "
         "10.0]\n[hub.drive]\nkind = \"torque\"\n"
         "torque = " +
         number(torque) + "\ninitial_speed = " + number(kSetPoint + error) + "\n" + kVane +
         "[control.pitch]\njoint = \"pitch\"\nspeed = " + number(kSetPoint) +
         "\nproportional = " + number(2.0 * kRatio * kFrequency / kSlope) +
         "\nintegral = " + number(kFrequency * kFrequency / kSlope) + "\n" + more;
}
const std::string kWide = "minimum = -0.5\nmaximum = 0.5\ninitial = 0.0\n";

/// Returns the error of the speed that the closed form has at time t, from an error at t = 0.
double closed_form(double error, double t) {
  const double decay = kRatio * kFrequency;
  const double turn = kFrequency * std::sqrt(1.0 - kRatio * kRatio);
  const double slope = -2.0 * decay * error;  // by the proportional part
  return std::exp(-decay * t) *
         (error * std::cos(turn * t) + (slope + decay * error) / turn * std::sin(turn * t));
}

/// Returns the largest distance from the closed form within 4 s, by the error at the start.
double distance_of(double step, const std::string& more, IntegrationMethod method) {
  constexpr double error = 1e-3;
  Simulation simulation(
      test::make_scenario(make_rotor(error, 0.0, kWide + more), step, 4.0, method),
      {Formulation::structured, ExecutorKind::serial, 1});
  const std::size_t speed = simulation.sensor_index("hub.speed");
  double largest = 0.0;
  simulation.run_until(4.0, [&](double t, std::span<const double> values) {
    largest = std::max(largest, std::abs(values[speed] - kSetPoint - closed_form(error, t)));
  });
  return largest / error;
}

/// Values of a column at the ends of all steps.
std::vector<double> run(const Scenario& scenario, const std::string& column) {
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  const std::size_t place = simulation.sensor_index(column);
  std::vector<double> values{simulation.sensor_values()[place]};
  simulation.run_until(scenario.integration.duration,
                       [&](double, std::span<const double> all) { values.push_back(all[place]); });
  return values;
}

}  // namespace

TEST_CASE(
    "the speed of a controlled rotor follows the closed form to the first order of a sample") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
    CAPTURE(name_of(method));
    const double coarse = distance_of(0.02, "", method);
    const double middle = distance_of(0.01, "", method);
    const double fine = distance_of(0.005, "", method);
    CHECK(fine < 0.015);  // 2 T times the frequency
    CHECK(coarse / middle == Approx(2.0).epsilon(0.1));
    CHECK(middle / fine == Approx(2.0).epsilon(0.05));
  }
}

TEST_CASE("a controller that samples more seldom than the steps has the error of its samples") {
  const auto distance = [](double step, const std::string& more) {
    return distance_of(step, more, IntegrationMethod::generalized_alpha);
  };
  const double by_step = distance(0.02, "");
  CHECK(distance(0.005, "period = 0.02\n") == Approx(by_step).epsilon(0.02));
  CHECK(distance(0.002, "period = 0.02\n") == Approx(by_step).epsilon(0.02));
}

TEST_CASE("a rotor comes to its set point where the vane balances the torque") {
  const Scenario scenario =
      test::make_scenario(make_rotor(0.1, 1.5, kWide + "rate = 0.2\nfilter = 20.0\n"), 0.01, 20.0);
  CHECK(run(scenario, "hub.speed").back() == Approx(kSetPoint).epsilon(1e-6));
  const double balance = std::asin(1.5 / 6.0);
  for (const char* column : {"vane.pitch", "control.pitch.angle", "control.pitch.demand"})
    CHECK(run(scenario, column).back() == Approx(balance).epsilon(1e-6));
  CHECK(std::abs(run(scenario, "control.pitch.rate").back()) < 1e-6);
}

TEST_CASE("the sign turns the joint the other way, beside its own motion") {
  std::string text = make_rotor(0.1, -1.5, kWide + "sign = -1\n");
  const std::string own = "motion = { constant = 0.0 }";
  text.replace(text.find(own), own.size(), "motion = { constant = 0.1 }");
  const Scenario scenario = test::make_scenario(text, 0.01, 20.0);
  const std::vector<double> joint = run(scenario, "vane.pitch");
  const std::vector<double> angle = run(scenario, "control.pitch.angle");
  REQUIRE(joint.size() == angle.size());
  for (std::size_t n = 0; n < joint.size(); ++n) CHECK(joint[n] == Approx(0.1 - angle[n]));
}

TEST_CASE("behind a saturation the speed does not overshoot by an integral that has wound up") {
  // A torque beyond the vane's lets the rotor run away for 5 s; when it is gone, the vane brakes.
  std::string text = make_rotor(0.0, 0.0, "minimum = 0.0\nmaximum = 0.2\nrate = 1.0\n");
  const std::string torque = "torque = 0";
  text.replace(text.find(torque), torque.size(),
               "time = [0.0, 5.0, 5.1, 100.0]\ntorque = [3.0, 3.0, 0.0, 0.0]");
  const std::vector<double> speed = run(test::make_scenario(text, 0.01, 30.0), "hub.speed");
  const double greatest = *std::max_element(speed.begin(), speed.end());
  CHECK(greatest > kSetPoint + 0.5);
  // The integral stood at 0.2 rad, no more: a loop that had gone on would have added 7 rad.
  const double least = *std::min_element(speed.begin(), speed.end());
  CHECK(least > kSetPoint - 0.1);
}

TEST_CASE("on a support a controller sees the speed of the hub against the axle") {
  std::string text = make_rotor(0.1, 1.5, kWide) + R"(
[support]
[[support.body]]
name = "nacelle"
kind = "rigid"
mass = 5.0
inertia = 3.0
[[support.joint]]
child = "nacelle"
kind = "revolute"
axis = [0.0, 0.0, 1.0]
motion = { time = [0.0, 100.0], value = [0.0, 30.0] }
[support.axle]
body = "nacelle"
)";
  Simulation simulation(test::make_scenario(text, 0.01, 20.0),
                        {Formulation::structured, ExecutorKind::serial, 1});
  simulation.run_until(20.0);
  CHECK(simulation.sensor("hub.speed") == Approx(kSetPoint).epsilon(1e-3));
  CHECK(simulation.hub_frame().angular_velocity.z() == Approx(kSetPoint + 0.3).epsilon(1e-3));
}

TEST_CASE("where a drive prescribes the speed, the demand is that of its course") {
  std::string text = make_rotor(0.0, 0.0, "minimum = 0.0\nmaximum = 1.0\n");
  const std::string drive = "kind = \"torque\"\ntorque = 0\ninitial_speed = 2\n";
  text.replace(text.find(drive), drive.size(), "kind = \"constant\"\nspeed = 2.01\n");
  const std::vector<double> demand =
      run(test::make_scenario(text, 0.01, 5.0), "control.pitch.demand");
  const double proportional = 2.0 * kRatio * kFrequency / kSlope * 0.01;
  const double integral = kFrequency * kFrequency / kSlope * 0.01;
  for (std::size_t n = 1; n < demand.size(); ++n)
    CHECK(demand[n] == Approx(proportional + integral * 0.01 * static_cast<double>(n)));
}

TEST_CASE("steady analyses hold joints under control at the initial angle") {
  const std::string booms = test::kBooms + R"([[blade.joint]]
name = "pitch"
station = 1.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
)";
  const auto frequencies = [&](const std::string& motion, const std::string& control) {
    Scenario scenario =
        test::make_scenario(test::make_text(test::kDrivenHub, booms + motion, control), 0.01, 1.0);
    std::vector<double> found;
    for (const Mode& mode : solve_modes(scenario, {}).modes) found.push_back(mode.frequency);
    return found;
  };
  const std::vector<double> controlled =
      frequencies("motion = { constant = 0.375 }\n",
                  "[control.pitch]\njoint = \"pitch\"\nspeed = 8.0\nproportional = 1.0\n"
                  "integral = 1.0\nminimum = 0.0\nmaximum = 1.0\ninitial = 0.25\nsign = -1\n");
  CHECK(controlled.size() > 4);
  CHECK(controlled == frequencies("motion = { constant = 0.125 }\n", ""));
  CHECK(controlled != frequencies("motion = { constant = 0.375 }\n", ""));
}
