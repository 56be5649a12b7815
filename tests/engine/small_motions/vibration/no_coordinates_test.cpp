// Tests subsystems without coordinates of their own on hubs that have some: the inertia that a
// rigid body adds to the hub, by closed forms.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/campbell.h"
#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/small_motions/vibration/frequency_limits.h"
#include "models/error.h"
#include "tests/message_of.h"

namespace spoke::without_coordinates {
namespace {

using doctest::Approx;

constexpr double kHubInertia = 0.5, kSpring = 50.0;
/// Inertia of a lump about the axle, and of a pendulum about its pin there.
constexpr double kLump = 0.05 + 0.6 * 0.6, kPendulum = 0.05 + 0.5 * 0.5;

std::string subsystem_text(const std::string& name, const std::string& joint) {
  return "[[subsystem]]\nname = \"" + name +
         "\"\n[[subsystem.body]]\nname = \"body\"\nkind = \"rigid\"\nmass = 1.0\n"
         "center = [0.5, 0.0, 0.0]\ninertia = [0.02, 0.05, 0.05]\n"
         "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"body\"\n" +
         joint;
}
/// A lump that is fixed 0.1 m from the axle in the direction of `angle`.
std::string lump(const std::string& name, double angle) {
  return subsystem_text(
      name, "kind = \"fixed\"\noffset = [" + std::to_string(0.1 * std::cos(angle)) + ", " +
                std::to_string(0.1 * std::sin(angle)) + ", 0.0]\norientation = [0.0, 0.0, " +
                std::to_string(angle) + "]\n");
}
/// A lump that is held by a joint of constant motion.
const std::string kHeld =
    subsystem_text("held",
                   "kind = \"revolute\"\naxis = [0.0, 0.0, 1.0]\noffset = [0.1, 0.0, 0.0]\n"
                   "motion = { time = [0.0], value = [0.0] }\n");
const std::string kSwinging =
    subsystem_text("swinging", "kind = \"revolute\"\naxis = [0.0, 0.0, 1.0]\nstiffness = 50.0\n");

std::string ring(int count) {
  std::string text;
  for (int k = 0; k < count; ++k)
    text += lump("lump" + std::to_string(k), 2.0 * std::numbers::pi * k / count);
  return text;
}

/// A hub that a torque turns: -0.5 N m s of its speed.
const std::string kBraked =
    "[hub]\ninertia = 0.5\n[hub.drive]\nkind = \"torque_by_speed\"\nspeed = [-4.0, 4.0]\n"
    "torque = [2.0, -2.0]\n";
const std::string kLoose = "[hub]\ninertia = 0.5\n[hub.drive]\nkind = \"free\"\n";
const std::string kFlying = "[hub]\nsupport = \"free\"\nmass = 2.0\ninertia = [0.5, 0.5, 0.5]\n";

Scenario parse(const std::string& hub, const std::string& bodies) {
  return parse_scenario("world = \"space\"\n" + hub + bodies + "[integration]\nduration = 1.0\n",
                        "rigid.toml");
}

ModesResult solve(const Scenario& scenario, int count, double speed = 0.0) {
  return solve_modes(scenario, {.state = {.speed = speed}, .count = count});
}

/// Returns the frequency of a hub of this inertia and the pendulum, which turn against one another.
double calc_frequency(double inertia) {
  return std::sqrt(kSpring * (1.0 / kPendulum + 1.0 / inertia));
}

}  // namespace

TEST_CASE("what has no coordinates slows a hub that a torque brakes by its inertia") {
  struct Case {
    std::string bodies;
    double inertia;
  };
  for (const Case& which :
       {Case{ring(1), kLump}, Case{ring(2), 2 * kLump}, Case{ring(5), 5 * kLump},
        Case{kHeld, kLump}, Case{kHeld + ring(4), 5 * kLump}}) {
    const Scenario scenario = parse(kBraked, which.bodies);
    const double rate = -0.5 / (kHubInertia + which.inertia);
    const std::vector<Mode> modes = solve(scenario, 1).modes;
    REQUIRE(modes.size() == 1);
    CHECK(modes[0].kind == "hub");
    CHECK(modes[0].eigenvalue == 0.0);  // wherever it stands
    const LinearSystem linear = solve_linear_system(scenario, {.speed = 0.0});
    CHECK(Eigen::MatrixXd(linear.A)(1, 1) == Approx(rate).epsilon(1e-6));
    CHECK(vibration::find_frequency_limits(scenario).highest == 0.0);
  }
}

TEST_CASE("a pendulum swings against a hub with what has no coordinates, and in any order") {
  const double frequency = calc_frequency(kHubInertia + 2 * kLump);
  for (const std::string& bodies :
       {ring(2) + kSwinging, kSwinging + ring(2), kSwinging + kHeld + lump("lump", 2.0)}) {
    const Scenario scenario = parse(kLoose, bodies);
    const std::vector<Mode> modes = solve(scenario, 2).modes;
    REQUIRE(modes.size() == 2);
    CHECK(modes[0].eigenvalue == 0.0);
    CHECK(modes[1].frequency == Approx(frequency).epsilon(1e-6));
    const vibration::FrequencyLimits limits = vibration::find_frequency_limits(scenario);
    CHECK(limits.lowest == Approx(frequency).epsilon(1e-6));
    CHECK(limits.highest == Approx(frequency).epsilon(1e-6));
    const CampbellResult campbell =
        solve_campbell(scenario, {.speeds = {0.0, 1.0}, .count = 2, .threads = 1});
    REQUIRE(campbell.branches.size() == 2);
    CHECK(campbell.states[0].modes[*campbell.branches[1].modes[0]].frequency ==
          Approx(frequency).epsilon(1e-6));
  }
}

TEST_CASE("a rigid model that flies has six rigid motions, with a lump or in a forest") {
  const std::string forest = R"([[subsystem]]
name = "forest"
[[subsystem.body]]
name = "left"
kind = "rigid"
mass = 1.0
inertia = [0.02, 0.05, 0.05]
[[subsystem.body]]
name = "right"
kind = "rigid"
mass = 1.0
inertia = [0.02, 0.05, 0.05]
[[subsystem.joint]]
parent = "hub"
child = "left"
kind = "fixed"
offset = [0.6, 0.0, 0.0]
[[subsystem.joint]]
parent = "hub"
child = "right"
kind = "fixed"
offset = [-0.6, 0.0, 0.0]
)";
  for (const std::string& bodies : {ring(1), ring(4), kHeld, forest}) {
    const std::vector<Mode> modes = solve(parse(kFlying, bodies), 6).modes;
    REQUIRE(modes.size() == 6);
    for (const Mode& mode : modes) CHECK(std::abs(mode.eigenvalue) < 1e-6);
    CHECK(vibration::find_frequency_limits(parse(kFlying, bodies)).highest == 0.0);
  }
  // Spinning, one of them is the nutation of a rigid body.
  const double A = 0.5 + 2.0 * 0.02, B = 0.5 + 2.0 * kLump, C = 0.9 + 2.0 * kLump;
  const double nutation = 2.0 * std::sqrt((C - A) * (C - B) / (A * B));
  const std::string hub = "[hub]\nsupport = \"free\"\nmass = 2.0\ninertia = [0.5, 0.5, 0.9]\n";
  for (const std::string& bodies : {ring(2), forest}) {
    const std::vector<Mode> modes = solve(parse(hub, bodies), 6, 2.0).modes;
    const auto nutates = [&](const Mode& mode) {
      return std::abs(mode.frequency - nutation) < 1e-5 * nutation;
    };
    CHECK(std::count_if(modes.begin(), modes.end(), nutates) == 1);
  }
}

TEST_CASE("a hub that stands leaves only what moves: its modes, none of what does not") {
  const std::string held = "[hub.drive]\nkind = \"fixed\"\n";
  const std::vector<Mode> modes = solve(parse(held, ring(2) + kSwinging), 1).modes;
  REQUIRE(modes.size() == 1);
  CHECK(modes[0].of == "swinging");
  CHECK(modes[0].frequency == Approx(std::sqrt(kSpring / kPendulum)).epsilon(1e-6));
  CHECK(test::message_of([&] { solve(parse(held, ring(2)), 1); }) ==
        "nothing of the model moves, expected a body or a joint that does");
  CHECK(vibration::find_frequency_limits(parse(held, ring(2))).highest == 0.0);
}

TEST_CASE("a hub in steady rotation holds what has no coordinates on its way") {
  for (const std::string& bodies : {ring(1), kHeld}) {
    const EquilibriumResult found = solve_equilibrium(parse(kBraked, bodies), {.speed = 3.0});
    CHECK(found.hub_force.x() == Approx(-9.0 * 0.6).epsilon(1e-6));
    CHECK(std::abs(found.hub_force.y()) < 1e-6);
  }
}

}  // namespace spoke::without_coordinates
