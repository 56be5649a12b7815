// The controller of [control.turbine]: laws by their closed forms, alone and on a rotor of vanes.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/simulation/turbine_controller.h"
#include "models/error.h"
#include "tests/engine/control/vanes.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
using doctest::Approx;

namespace {

constexpr double kPeriod = 0.01;  // s
constexpr double kTurn = 2.0 * std::numbers::pi;

/// A controller of three blades that is told what a test sets.
class Told {
 public:
  explicit Told(TurbineLaws laws, double initial = 0.0)
      : controller(make_turbine_controller(std::move(laws), initial,
                                           {0.0, kTurn / 3.0, 2.0 * kTurn / 3.0})) {
    record.period = kPeriod;
    record.blades.resize(3);
    commands.pitch.assign(3, initial);
  }
  /// Tells it the record for so many samples.
  void go(int samples = 1) {
    for (int i = 0; i < samples; ++i) {
      controller->control(record, commands);
      record.is_first = false;
    }
  }

  std::shared_ptr<Controller> controller;
  ControlRecord record;
  ControlCommands commands;
};

TorqueLaw square_law() {
  TorqueLaw law;
  law.square = 2.0;
  law.speed = 3.0;
  law.rated = 24.0;
  law.transition = 2.5;
  return law;
}

double torque_at(const TorqueLaw& law, double speed) {
  Told told({.torque = law});
  told.record.speed = speed;
  told.go();
  return -told.commands.torque;
}

PitchLaw pitch_law() {
  PitchLaw law;
  law.speed = 2.0;
  law.proportional = {0.5};
  law.integral = {0.2};
  law.maximum = 1.5;
  return law;
}

}  // namespace

TEST_CASE("turbine torque: a square below rated, a straight way, and one power above") {
  TorqueLaw law = square_law();
  CHECK(torque_at(law, -1.0) == 0.0);
  CHECK(torque_at(law, 1.5) == Approx(4.5));
  CHECK(torque_at(law, 2.5) == Approx(12.5));
  CHECK(torque_at(law, 2.75) == Approx(0.5 * (12.5 + 24.0)));
  CHECK(torque_at(law, 3.0) == Approx(24.0));
  CHECK(torque_at(law, 4.0) == Approx(24.0 * 3.0 / 4.0));
  law.above = AboveRated::torque;
  CHECK(torque_at(law, 4.0) == Approx(24.0));
  law.above = AboveRated::power;
  law.maximum = 20.0;
  CHECK(torque_at(law, 3.0) == Approx(20.0));
  law.square = 0.0;
  law.table_speed = {0.0, 1.0, 2.0};
  law.table_torque = {0.0, 1.0, 5.0};
  CHECK(torque_at(law, 1.5) == Approx(3.0));
  CHECK(torque_at(law, 2.4) == Approx(5.0));
}

TEST_CASE("turbine torque: gains hold rated speed between the square and what is rated") {
  TorqueLaw law = square_law();
  law.transition.reset();
  law.proportional = 10.0;
  law.integral = 4.0;
  law.minimum = 1.0;
  Told told({.torque = law});
  told.record.speed = 2.0;  // far below: the square
  told.go(500);
  CHECK(-told.commands.torque == Approx(8.0));
  told.record.speed = 3.1;  // beyond: the law from the square of this speed on
  told.go(20);
  CHECK(-told.commands.torque ==
        Approx(2.0 * 3.1 * 3.1 + 0.1 * (10.0 + 20 * kPeriod * 4.0)).epsilon(0.02));
  told.go(3000);
  CHECK(-told.commands.torque == Approx(24.0 * 3.0 / 3.1));
  told.record.speed = 0.9;  // below the least speed: it lets go
  told.go(5000);
  CHECK(told.commands.torque == 0.0);
}

TEST_CASE("turbine torque: its rate is limited, and pitch may hold it at what is rated") {
  TorqueLaw law = square_law();
  law.rate = 10.0;
  Told told({.torque = law});
  told.record.speed = 1.0;
  told.go();
  told.record.speed = 3.0;
  told.go(10);
  CHECK(-told.commands.torque == Approx(2.0 + 10 * kPeriod * 10.0));
  law = square_law();
  law.switch_pitch = 0.1;
  Told pitched({.torque = law, .pitch = pitch_law()}, 0.2);
  pitched.record.speed = 1.5;
  pitched.go();
  CHECK(-pitched.commands.torque == Approx(24.0 * 3.0 / 1.5));
}

TEST_CASE("turbine pitch: both gains have tables of their own, of any sign, and limits hold") {
  PitchLaw law = pitch_law();
  law.angle = {0.0, 0.4};
  law.proportional = {0.5, -0.1};
  law.integral = {0.2, 0.1};
  Told told({.pitch = law}, 0.2);
  told.record.speed = 2.3;
  told.go();
  CHECK(told.commands.pitch[1] == Approx(0.2 + 0.3 * (0.2 + 0.15 * kPeriod)));
  law = pitch_law();
  law.rate = 0.05;
  Told slow({.pitch = law}, 0.2);
  slow.record.speed = 9.0;
  slow.go(10);
  CHECK(slow.commands.pitch[0] == Approx(0.2 + 10 * kPeriod * 0.05));
  slow.go(100000);
  CHECK(slow.commands.pitch[0] == Approx(1.5));
  slow.record.speed = 1.9;  // the integral has not gone beyond the limit
  slow.go(2);
  CHECK(slow.commands.pitch[0] < 1.5);
}

TEST_CASE("turbine pitch: the least angle goes by the filtered wind") {
  TurbineLaws laws{.pitch = pitch_law()};
  laws.schedule = PitchSchedule{{4.0, 8.0, 12.0}, {0.1, 0.0, 0.2}, 0.5};
  Told told(laws);
  told.record.speed = 1.0;
  told.record.wind_speed = 4.0;
  told.go(10000);
  CHECK(told.commands.pitch[0] == Approx(0.1));
  told.record.wind_speed = 11.0;
  told.go(100);
  const double wind = 11.0 - 7.0 * std::exp(-0.5 * 100 * kPeriod);
  CHECK(told.commands.pitch[0] == Approx(interpolate({4.0, 8.0, 12.0}, {0.1, 0.0, 0.2}, wind)));
}

TEST_CASE("turbine set points give way: that of pitch below rated, that of the torque above") {
  TurbineLaws laws{.torque = square_law(), .pitch = pitch_law()};
  laws.smoothing = SetPointSmoothing{0.5, 0.1, 0.3};
  Told below(laws);
  below.record.speed = 1.5;
  below.go(10000);
  // The pitch rests at its least angle where the speed stays below the set point that has risen.
  const double missing = 1.0 - 4.5 * 1.5 / (24.0 * 3.0);
  const double set_point = 2.0 * (1.0 + 0.1 * missing);
  below.record.speed = set_point + 0.1;
  below.go();
  CHECK(below.commands.pitch[0] == Approx(0.1 * (0.5 + 0.2 * kPeriod)).epsilon(0.01));
  // Above rated the way of the torque begins earlier.
  PitchLaw still = pitch_law();
  still.proportional = {};
  still.integral = {0.0};
  laws.pitch = still;
  Told above(laws, std::numbers::pi / 12.0);
  above.record.speed = 2.6;
  above.go(10000);
  const double power = -above.commands.torque * 2.6 / (24.0 * 3.0);
  const double shift = 2.0 * (0.5 * 0.5 - 0.1 * (1.0 - power));
  CHECK(-above.commands.torque == Approx(calc_straight_torque(square_law(), 2.6, shift)));
  CHECK(-above.commands.torque > calc_straight_torque(square_law(), 2.6) + 1.0);
}

TEST_CASE("turbine filters and actuators follow their differential equations") {
  constexpr double w = 4.0, z = 0.3, seconds = 0.8;
  PitchLaw law = pitch_law();
  law.proportional = {1.0};
  law.integral = {};
  const auto step_answer = [&](double t) {  // of x'' + 2 z w x' + w^2 x = w^2
    const double wd = w * std::sqrt(1.0 - z * z);
    return 1.0 - std::exp(-z * w * t) * (std::cos(wd * t) + z * w / wd * std::sin(wd * t));
  };
  const int samples = static_cast<int>(std::lround(seconds / kPeriod));
  Told actuated({.pitch = law, .actuator = PitchActuator{w, z}});
  actuated.record.speed = 2.0;
  actuated.go();
  actuated.record.speed = 2.5;
  actuated.go(samples);
  CHECK(actuated.commands.pitch[2] ==
        Approx(0.5 * step_answer(seconds + 0.5 * kPeriod)).epsilon(1e-3));
  TorqueLaw torque = square_law();
  torque.square = 0.0;
  torque.table_speed = {0.0, 10.0};
  torque.table_torque = {0.0, 10.0};
  torque.speed = torque.rated = 20.0;
  torque.transition.reset();
  Told filtered({.filter = SpeedFilter{w, z}, .torque = torque});
  filtered.record.speed = 1.0;
  filtered.go();
  filtered.record.speed = 2.0;
  filtered.go(samples);
  CHECK(-filtered.commands.torque ==
        Approx(1.0 + step_answer(seconds + 0.5 * kPeriod)).epsilon(1e-3));
  Told first({.filter = SpeedFilter{w, std::nullopt}, .torque = torque});
  first.record.speed = 1.0;
  first.go();
  first.record.speed = 2.0;
  first.go(samples);
  CHECK(-first.commands.torque == Approx(2.0 - std::exp(-w * seconds)));
}

TEST_CASE("turbine individual pitch answers what tilts and yaws the rotor, not what bends all") {
  TurbineLaws laws{.pitch = pitch_law()};
  laws.individual = IndividualPitch{0.0, 1e-3, 0.2, 0.0, 5.0, 10.0};
  Told told(laws, 0.3);
  told.record.speed = 2.0;
  told.record.wind_speed = 12.0;
  const auto turn = [&](double tilt, double yaw, int samples) {
    for (int i = 0; i < samples; ++i) {
      told.record.azimuth = std::fmod(0.02 * i, kTurn);
      for (int k = 0; k < 3; ++k) {
        const double azimuth = told.record.azimuth + k * kTurn / 3.0;
        told.record.blades[static_cast<std::size_t>(k)].out_of_plane_moment =
            50.0 + tilt * std::cos(azimuth) + yaw * std::sin(azimuth);
      }
      told.go();
    }
  };
  turn(0.0, 0.0, 1000);
  for (const double pitch : told.commands.pitch) CHECK(pitch == Approx(0.3));
  turn(8.0, -4.0, 500);
  const double azimuth = told.record.azimuth;
  const double tilt = 1e-3 * 8.0 * 500 * kPeriod, yaw = -0.5 * tilt;
  for (int k = 0; k < 3; ++k) {
    const double at = azimuth + k * kTurn / 3.0;
    CHECK(told.commands.pitch[static_cast<std::size_t>(k)] ==
          Approx(0.3 + tilt * std::cos(at) + yaw * std::sin(at)));
  }
  told.record.wind_speed = 5.0;  // none in little wind
  told.go();
  CHECK(told.commands.pitch[0] == Approx(0.3));
}

TEST_CASE("turbine yaw turns from an error on until there is none") {
  Told told({.yaw = YawLaw{0.005, 0.1, std::nullopt}});
  const auto rate_at = [&](double error) {
    told.record.yaw_error = error;
    told.go();
    return told.commands.yaw_rate;
  };
  CHECK(rate_at(0.09) == 0.0);
  CHECK(rate_at(0.11) == 0.005);
  CHECK(rate_at(0.01) == 0.005);
  CHECK(rate_at(-0.01) == 0.0);
  CHECK(rate_at(-0.2) == -0.005);
  CHECK(rate_at(0.2) == 0.005);
}

TEST_CASE("turbine controllers go on from what they saved, to the bit") {
  TurbineLaws laws{.filter = SpeedFilter{3.0, 0.7}, .torque = square_law(), .pitch = pitch_law()};
  laws.smoothing = SetPointSmoothing{1.0, 0.001, 0.6};
  laws.actuator = PitchActuator{5.0, 0.7};
  Told told(laws);
  told.record.speed = 2.7;
  told.go(37);
  const std::string saved = *told.controller->save();
  const std::shared_ptr<Controller> clone = told.controller->clone();
  Told other(laws);
  other.controller->restore(saved);
  other.record = told.record;
  other.commands = told.commands;
  told.go(11);
  other.go(11);
  ControlCommands cloned = told.commands;
  for (int i = 0; i < 11; ++i) clone->control(told.record, cloned);
  CHECK(told.commands.pitch[0] > 0.0);
  CHECK(other.commands.pitch == told.commands.pitch);
  CHECK(other.commands.torque == told.commands.torque);
  CHECK(cloned.pitch == told.commands.pitch);
  CHECK(cloned.torque == told.commands.torque);
  CHECK(message_of([&] { other.controller->restore("1.0 words"); }) ==
        "the saved state is not one of [control.turbine]");
}

TEST_CASE("a turbine's torque by the square of the speed slows a rotor as its closed form does") {
  const auto distance = [](double step) {
    constexpr double k = 0.5, start = 2.0, seconds = 5.0;
    Scenario scenario = parse_scenario(
        make_vanes("[control.turbine]\n[control.turbine.torque]\nsquare = 0.5\nspeed = 30.0\n"
                   "rated = 450.0\n"),
        "vanes.toml");
    scenario.integration.step = step;
    Simulation simulation(scenario, {.executor = ExecutorKind::serial});
    simulation.run_until(seconds);
    return simulation.sensor("hub.speed") - start / (1.0 + k * start * seconds / kVaneInertia);
  };
  const double coarse = distance(0.01), fine = distance(0.005);
  CHECK(std::abs(fine) < 0.01);
  CHECK(coarse / fine == Approx(2.0).epsilon(0.1));  // the torque is late by a sample
}

TEST_CASE("a turbine's pitch holds its set point against a drive that stays the scenario's") {
  const Scenario scenario = parse_scenario(
      make_vanes("[control.turbine]\njoint = \"pitch\"\n[control.turbine.pitch]\nspeed = 2.5\n"
                 "proportional = 0.8\nintegral = 0.4\nminimum = -1.0\nmaximum = 1.0\n",
                 "[gravity]\nacceleration = [0.0, 0.0, 0.0]\n" + kLift),
      "vanes.toml", {"hub.drive.torque=3.0", "integration.duration=40.0"});
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  simulation.run_until(40.0);
  CHECK(simulation.sensor("hub.speed") == Approx(2.5).epsilon(1e-5));
  // Lift turns with the pitch, and holds what the drive still gives: 18 sin(pitch) = 3.
  CHECK(simulation.sensor("control.pitch.angle") == Approx(std::asin(3.0 / 18.0)).epsilon(1e-4));
}

TEST_CASE("a turbine's nacelle turns into the wind, and stays there") {
  for (const double across : {4.0, -4.0}) {
    CAPTURE(across);
    std::string text = make_vanes(
        "[control.turbine]\nyaw_joint = \"yaw\"\nperiod = 0.05\n[control.turbine.yaw]\nrate = "
        "0.1\nerror = 0.2\n",
        "[gravity]\nacceleration = [0, 0, -10.0]\n[air]\n[wind]\nvelocity = [8.0, " +
            std::to_string(across) + R"(, 0.0]
[support]
[[support.body]]
name = "nacelle"
kind = "rigid"
mass = 5.0
inertia = 2.0
[[support.joint]]
name = "yaw"
parent = "ground"
child = "nacelle"
kind = "revolute"
axis = [0.0, 0.0, 1.0]
motion = { constant = 0.0 }
[support.axle]
body = "nacelle"
)");
    text.insert(text.find("inertia = [8.0"), "axis = [1.0, 0.0, 0.0]\n");
    text.insert(text.find("mass = 0.5"), "drag = { area = [1e-12, 1e-12, 1e-12] }\n");
    Simulation simulation(parse_scenario(text, "vanes.toml"), {.executor = ExecutorKind::serial});
    simulation.run_until(2.0);
    const double askew = std::atan2(across, 8.0);
    CHECK(std::abs(simulation.sensor("support.yaw")) < std::abs(askew));
    simulation.run_until(8.0);
    // The last demand goes beyond by less than two periods.
    CHECK(simulation.sensor("support.yaw") == Approx(askew).epsilon(0.02));
  }
}
