// What inputs of an FMU do: against the same changes made to a simulation, and against the laws of
// motion.

#include "program/fmu/inputs.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/courses.h"
#include "program/fmu/speed_course.h"
#include "tests/contains.h"
#include "tests/message_of.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/unpacked_fmu.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

std::vector<std::string> names_of(const fmu::Inputs& inputs) {
  std::vector<std::string> names;
  for (const auto& input : inputs) names.push_back(input->name);
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a model offers the inputs that it has, and chooses among them by name") {
  const Simulation pitched = simulate(kPitchedRotor), driven = simulate(kDrivenRotor);
  CHECK(names_of(fmu::possible_inputs(pitched)) ==
        Names{"drive.torque", "load.gust", "load.brake", "blade1.pitch.velocity",
              "blade1.pitch.acceleration", "blade2.pitch.velocity", "blade2.pitch.acceleration"});
  CHECK(names_of(fmu::choose_inputs(pitched, {})) == Names{"drive.torque", "load.gust",
                                                           "load.brake", "blade1.pitch.velocity",
                                                           "blade2.pitch.velocity"});
  CHECK(names_of(fmu::choose_inputs(driven, {})) == Names{"drive.speed"});
  CHECK(names_of(fmu::choose_inputs(pitched, {"blade2.pitch.acceleration", "drive.torque"})) ==
        Names{"blade2.pitch.acceleration", "drive.torque"});
  const auto refused = [&](const Simulation& simulation, const Names& names) {
    return message_of([&] { fmu::choose_inputs(simulation, names); });
  };
  CHECK(contains(refused(pitched, {"drive.torqe"}), "drive.torque"));
  CHECK(contains(refused(driven, {"drive.torque"}), "drive.speed"));
  CHECK(contains(refused(pitched, {"load.gust", "load.gust"}), "twice"));
  CHECK(contains(refused(pitched, {"blade1.pitch.velocity", "blade1.pitch.acceleration"}),
                 "the same motion"));
  CHECK(fmu::choose_inputs(pitched, {"drive.torque"})[0]->start == 3.0);
  CHECK(fmu::choose_inputs(pitched, {"blade1.pitch.velocity"})[0]->unit == "rad/s");
}

TEST_CASE(
    "torque and factors of loads are those that a program sets on a simulation, bit for bit") {
  const UnpackedFmu unpacked(kPitchedRotor);
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  Simulation simulation = simulate(kPitchedRotor);
  for (int k = 0; k < 12; ++k) {
    const double torque = std::floor(k / 3.0) - 2.0, gust = k < 5 ? 1.0 : -1.5;
    CHECK(instance.set({"drive.torque", "load.gust"}, {torque, gust}) == kOk);
    if (k % 3 == 0) simulation.set_drive(TorqueDrive{Curve(torque), 4.0});
    if (k == 5) set_load_factor(simulation, "gust", gust);
    CHECK(instance.step(0.02 * k, 0.02) == kOk);
    simulation.run_until(0.02 * (k + 1));
    CHECK(instance.outputs() == values_of(simulation));
  }
  // The start values, set or not, leave the scenario's own courses in force.
  FmuInstance plain(fmu), same(fmu);
  CHECK(plain.initialize() == kOk);
  CHECK(same.initialize() == kOk);
  CHECK(same.set({"drive.torque", "load.gust"}, {3.0 * (1.0 + 4e-16), 1.0}) == kOk);
  CHECK(plain.step(0.0, 0.2) == kOk);
  CHECK(same.step(0.0, 0.2) == kOk);
  CHECK(plain.outputs() == same.outputs());
}

TEST_CASE("a hub reaches the speed that an input asks for, at the end of each step") {
  const UnpackedFmu unpacked(kDrivenRotor);
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  double speed = 0.0, angle = 0.0;
  for (int k = 0; k < 200; ++k) {
    const double next = k < 3 ? 0.0 : k < 150 ? 2.0 + std::sin(0.3 * k) : 1.0;
    CHECK(instance.set({"drive.speed"}, {next}) == kOk);
    const int parts = k == 20 ? 7 : 2;
    CHECK(instance.step(instance.get({"time"})[0], 0.01 * parts) == kOk);
    if (k < 3) {  // the scenario's own spin-up, until the input differs from its start value
      speed = instance.get({"hub.speed"})[0];
      angle = instance.get({"hub.angle"})[0];
      continue;
    }
    angle += 0.01 * parts * (speed + next) / 2.0;
    speed = next;
    CHECK(instance.get({"hub.speed"})[0] == doctest::Approx(next).epsilon(1e-9));
    CHECK(instance.get({"hub.angle"})[0] == doctest::Approx(angle).epsilon(1e-9));
  }
}

TEST_CASE("a joint reaches its velocity, or has its acceleration, over each step") {
  const UnpackedFmu unpacked(kPitchedRotor, {"blade1.pitch.velocity", "blade2.pitch.acceleration"});
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  Simulation simulation = simulate(kPitchedRotor);
  const int pitch = simulation.joint_index(0, "pitch");
  double value = 0.1, velocity = 0.0;
  for (int k = 0; k < 30; ++k) {
    const double next = k < 10 ? 0.05 * k : 0.5, acceleration = k == 0 ? 0.0 : std::cos(0.4 * k);
    CHECK(instance.set({"blade1.pitch.velocity", "blade2.pitch.acceleration"},
                       {next, acceleration}) == kOk);
    CHECK(instance.step(0.008 * k, 0.008) == kOk);
    value += 0.008 * (velocity + next) / 2.0;
    velocity = next;
    // The same with a simulation: what a controller does by accelerations.
    CoordinateMotion one = simulation.joint_motion(0, pitch);
    one.acceleration = (next - one.velocity) / 0.008;
    CoordinateMotion two = simulation.joint_motion(1, pitch);
    two.acceleration = acceleration;
    if (k > 0) {  // both inputs have had their start values until then
      simulation.set_joint_motion(0, pitch, 0, one);
      simulation.set_joint_motion(1, pitch, 0, two);
    }
    simulation.run_until(0.008 * (k + 1));
    CHECK(simulation.joint_motion(0, pitch).value == doctest::Approx(value).epsilon(1e-9));
    for (const std::string name : {"blade1.tip.z", "blade2.tip.z", "hub.speed"}) {
      CAPTURE(name);
      CHECK(instance.get({name})[0] == doctest::Approx(simulation.sensor(name)).epsilon(1e-6));
    }
  }
}

TEST_CASE("a motor on a joint is that of a program, and is taken back with the state") {
  const std::string arm = R"(
world = "space"
[hub.drive]
kind = "fixed"
[[subsystem]]
name = "arm"
body = [{ name = "upper", kind = "rigid", mass = 2.0, center = [0.5, 0.0, 0.0], inertia = 0.2 }]
joint = [{ name = "shoulder", parent = "hub", child = "upper", kind = "revolute", axis = [0, 1, 0] }]
[integration]
step = 0.004
duration = 1.0
)";
  CHECK(names_of(fmu::choose_inputs(simulate(arm), {})) == Names{"drive.speed"});
  CHECK(fmu::choose_inputs(simulate(arm), {"arm.shoulder.torque"})[0]->unit == "N m");
  const UnpackedFmu unpacked(arm, {"arm.shoulder.torque"});
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  Simulation simulation = simulate(arm);
  for (int k = 0; k < 20; ++k) {
    const double torque = std::sin(0.3 * k);
    CHECK(instance.set({"arm.shoulder.torque"}, {torque}) == kOk);
    CHECK(instance.step(0.008 * k, 0.008) == kOk);
    set_joint_torque(simulation, 0, 0, 0, torque);
    simulation.run_until(0.008 * (k + 1));
    CHECK(instance.get({"arm.shoulder"})[0] == simulation.sensor("arm.shoulder"));
  }
}

TEST_CASE("a course of speed passes through angle and speed, at constant acceleration") {
  for (const double t : {0.0, 1e-3, 0.7, 3600.0})
    for (const double angle : {0.0, -2.5, 12.0, 1e5})
      for (const double speed : {0.0, 1.5, -3.0})
        for (const double target : {speed, 2.0, -40.0}) {
          const double step = 0.02, start = t == 0.0 ? 0.0 : angle;
          CAPTURE(t);
          CAPTURE(angle);
          const Curve course = fmu::speed_course(t, start, speed, target, step);
          CHECK(std::abs(course.value(t) - speed) <= 1e-12 * (1.0 + std::abs(speed)));
          CHECK(std::abs(course.integral(t) - start) <= 1e-14 * (1e3 + std::abs(start)) + 1e-10);
          for (const double share : {0.25, 0.5, 1.0}) {
            const double s = share * step;
            CHECK(course.value(t + s) ==
                  doctest::Approx(speed + (target - speed) * share).epsilon(1e-9));
          }
          CHECK(course.value(t + 2.0 * step) == target);
        }
}

TEST_CASE("drives of further rotors are inputs by their names, and states hold them") {
  const std::string rotors = R"(world = "space"
[integration]
step = 1e-3
duration = 1.0
[support]
from = "ground"
[[support.body]]
name = "frame"
kind = "rigid"
mass = 20.0
inertia = 5.0
[[support.joint]]
child = "frame"
kind = "fixed"
[[rotor]]
name = "main"
hub = { mass = 2.0, inertia = 0.3, drive = { kind = "constant", speed = 10.0 } }
axle = { body = "frame" }
[[rotor]]
name = "tail"
hub = { mass = 1.0, inertia = 0.1, drive = { kind = "free", initial_speed = 20.0 } }
axle = { body = "frame", offset = [-3.0, 0.0, 0.0] }
[[rotor]]
name = "weld"
hub = { mass = 1.0, inertia = 0.1, drive = { kind = "fixed" } }
axle = { body = "frame", offset = [3.0, 0.0, 0.0] }
)";
  const UnpackedFmu unpacked(rotors);
  const LoadedFmu fmu(unpacked.folder());
  Simulation simulation = simulate(rotors);
  CHECK(names_of(fmu::choose_inputs(simulation, {})) == Names{"drive.speed", "tail.drive.torque"});
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  CHECK(instance.set({"tail.drive.torque"}, {-0.5}) == kOk);
  CHECK(instance.step(0.0, 0.1) == kOk);
  simulation.set_drive(TorqueDrive{Curve(-0.5), 20.0}, "tail");
  simulation.run_until(0.1);
  CHECK(instance.outputs() == values_of(simulation));
  CHECK(instance.get({"tail.hub.speed"})[0] == doctest::Approx(20.0 - 0.1 * 0.5 / 0.1));
  // By way of bytes, in an instance that has not begun.
  void* state = nullptr;
  CHECK(instance.get_state(&state) == kOk);
  FmuInstance later(fmu);
  void* read = nullptr;
  CHECK(later.deserialize(instance.serialize(state), &read) == kOk);
  CHECK(later.set_state(read) == kOk);
  CHECK(instance.step(0.1, 0.1) == kOk);
  CHECK(later.step(0.1, 0.1) == kOk);
  CHECK(later.outputs() == instance.outputs());
}
