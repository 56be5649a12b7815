// Tests warnings of prescribed motions of joints and of the mount that jump.

#include "engine/simulation/jumps.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/contains.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Makes a blade that is pitched, on a mount.
Scenario pitched(const std::string& motion, const std::string& mount = "") {
  return parse_scenario(R"(
world = "space"
[hub.drive]
kind = "constant"
speed = 5.0
)" + mount + R"(
[blade]
count = 2
length = 2.0
bodies = 1
elements = 2
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e5
flap_stiffness = 50.0
lag_stiffness = 50.0
torsion_stiffness = 50.0
[[blade.joint]]
name = "pitch"
station = 0.0
kind = "revolute"
axis = [1, 0, 0]
motion = )" + motion + R"(
[integration]
step = 0.005
duration = 0.4
)",
                        "jump.toml");
}

std::string warning_of(const Simulation& simulation) {
  for (const Warning& warning : simulation.warnings())
    if (warning.kind == WarningKind::speed_jump) return warning.text;
  return {};
}
std::string warning_of(const Scenario& scenario) {
  return warning_of(Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}));
}

/// Makes a table of `count` points of a function, `interval` [s] apart.
template <class Function>
std::string table_of(int count, double interval, Function function) {
  std::string times, values;
  for (int k = 0; k < count; ++k) {
    times += (k > 0 ? ", " : "") + std::to_string(interval * k);
    values += (k > 0 ? ", " : "") + std::to_string(function(interval * k));
  }
  return "{ time = [" + times + "], value = [" + values + "] }";
}

}  // namespace

TEST_CASE("a joint that jumps is warned of, and its energy") {
  const Scenario scenario =
      pitched("{ time = [0.0, 0.1, 0.100000001, 1.0], value = [0.0, 0.0, 0.3, 0.3] }");
  const std::string text = warning_of(scenario);
  CAPTURE(text);
  CHECK(contains(text,
                 "at t = 0.1 s the joint \"pitch\" of blade 1 moves by 0.3 rad within 1e-09 "
                 "s, less than 4 steps: the energy of that comes from nowhere"));
  CHECK(text.ends_with("; let the change take 0.02 s or more"));
}

TEST_CASE("a joint whose table ends in motion is warned of") {
  const std::string text = warning_of(pitched("{ time = [0.0, 0.1, 0.2], value = [0, 0.1, 0.2] }"));
  CAPTURE(text);
  CHECK(contains(text,
                 "at t = 0.2 s the joint \"pitch\" of blade 1 changes its speed by -1 rad/s "
                 "at once"));
  CHECK(contains(text, "give the first and the last value of the table twice"));
  CHECK(warning_of(pitched("{ time = [0, 0.1, 0.2, 0.3], value = [0, 0, 0.2, 0.2] }")).empty());
  // This jump is after the end of the run.
  CHECK(warning_of(pitched("{ time = [0, 0.2, 0.4], value = [0, 0.1, 0.2] }")).empty());
}

TEST_CASE("a table of many points of a smooth motion jumps nowhere") {
  const auto smooth = [](double t) { return 0.2 * std::pow(std::sin(5.0 * t), 2); };
  CHECK(warning_of(pitched(table_of(500, 0.001, smooth))).empty());
  // A jump among these points warns.
  const auto jump = [&](double t) { return smooth(t) + (t > 0.2005 ? 0.01 : 0.0); };
  CHECK(contains(warning_of(pitched(table_of(500, 0.001, jump))), "at t = 0.2 s"));
  // A change within less than four steps in many points warns, too.
  const auto ramp = [](double t) { return t < 0.2 ? 0.0 : t < 0.215 ? 20.0 * (t - 0.2) : 0.3; };
  CHECK_FALSE(warning_of(pitched(table_of(500, 0.001, ramp))).empty());
}

TEST_CASE("a mount that jumps is warned of") {
  const std::string still = "{ constant = 0.1 }";
  const std::string text = warning_of(pitched(
      still, "[hub.mount]\ntranslation = { time = [0, 0.1, 0.100000001, 1], z = [0, 0, 2, 2] }"));
  CAPTURE(text);
  CHECK(contains(text, "at t = 0.1 s the mount's translation along z moves by 2 m within 1e-09 s"));
  CHECK(contains(warning_of(pitched(still,
                                    "[hub.mount]\nrotation = { time = [0, 0.1, 0.11, 1], "
                                    "x = [0, 0, 0.2, 0.2] }")),
                 "the mount's rotation along x moves by 0.2 rad within 0.01 s"));
  CHECK(warning_of(pitched(still,
                           "[hub.mount]\ntranslation = { time = [0, 0.1, 0.3, 1], z = [0, "
                           "0, 0.1, 0.1] }"))
            .empty());
  CHECK(warning_of(pitched(still,
                           "[hub.mount]\nrotation = { amplitude = [0.1, 0, 0], frequency "
                           "= 6.0 }"))
            .empty());
}

TEST_CASE("what the program lets jump is warned of until it thinks better of it") {
  Simulation simulation(pitched("{ by = 'program' }"),
                        {Formulation::structured, ExecutorKind::serial, 1});
  CHECK(warning_of(simulation).empty());
  simulation.set_joint_motion(0, 0, 0, Curve({0.0, 0.1, 0.1 + 1e-9, 1.0}, {0.0, 0.0, 0.3, 0.3}));
  CHECK(contains(warning_of(simulation), "(\"pitch\") of blade 1 moves by 0.3 rad within 1e-09 s"));
  simulation.set_joint_motion(0, 0, 0, Curve({0.0, 0.1, 0.3, 1.0}, {0.0, 0.0, 0.1, 0.1}));
  CHECK(warning_of(simulation).empty());
  simulation.set_drive(SpeedTable{Curve({0.0, 0.2, 0.2 + 1e-9}, {5.0, 5.0, 7.0})});
  CHECK(contains(warning_of(simulation), "at t = 0.2 s the drive changes the speed by 2 rad/s"));
}

TEST_CASE("where a jump ends a simulation, or makes energy, smaller steps are not the advice") {
  const auto what = [](const Scenario& scenario) -> std::string {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
    try {
      simulation.run_until(0.4, [](double, std::span<const double>) {});
    } catch (const DivergenceError& error) {
      return error.what();
    }
    for (const Warning& warning : simulation.warnings())
      if (warning.kind == WarningKind::energy_growth) return warning.text;
    return {};
  };
  const std::string advice = "let the change take 0.02 s or more";
  const std::string flung =
      what(pitched("{ time = [0.0, 0.1, 0.100000001, 1.0], value = [0.0, 0.0, 0.3, 0.3] }"));
  CHECK(contains(flung, "the joint \"pitch\" of blade 1 moves by 0.3 rad at t = 0.1 s, " + advice));
  const std::string shaken = what(
      pitched("{ constant = 0.1 }",
              "[hub.mount]\ntranslation = { time = [0, 0.1, 0.100000001, 1], z = [0, 0, 2, 2] }"));
  CHECK(contains(shaken, "the mount's translation along z moves by 2 m at t = 0.1 s, " + advice));
}
