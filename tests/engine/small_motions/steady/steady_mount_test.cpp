// Equilibria and modes of a rotor whose axle is on a mount.

#include "engine/small_motions/steady/steady_mount.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

constexpr double kTilt = 0.4;
const std::string kGravity = "[gravity]\nacceleration = [0.2, 0.1, -0.5]\n";

/// Makes a rotor on a mount with the keys `mount`; none: at rest.
Scenario make_rotor(const std::string& mount, const std::string& more = "") {
  const std::string table = mount.empty() ? "" : "[hub.mount]\n" + mount + "\n";
  return test::make_spatial(
      {.bodies = 2, .elements = 2, .radius = 0.1, .more = kGravity + table + more});
}

/// Makes the rotor at rest on the ground, its axis turned about y.
Scenario make_tilted() {
  Scenario scenario = make_rotor("");
  scenario.space->hub.axis = {std::sin(kTilt), 0.0, std::cos(kTilt)};
  return scenario;
}

void check_equal(const Scenario& scenario, const Scenario& other) {
  for (const double speed : {0.0, 2.0}) {
    CAPTURE(speed);
    const ModesResult a = solve_modes(scenario, {.state = {.speed = speed}, .count = 6});
    const ModesResult b = solve_modes(other, {.state = {.speed = speed}, .count = 6});
    const Eigen::Vector3d tip = a.equilibrium.blades.at(0).tip_displacement;
    CHECK(tip.norm() > 0.01);
    CHECK((tip - b.equilibrium.blades.at(0).tip_displacement).norm() < 1e-10);
    CHECK((a.equilibrium.hub_moment - b.equilibrium.hub_moment).norm() < 1e-9);
    for (std::size_t k = 0; k < a.modes.size(); ++k)
      CHECK(a.modes[k].frequency == doctest::Approx(b.modes[k].frequency).epsilon(1e-8));
  }
}

}  // namespace

TEST_CASE("steady: a mount that is turned is a hub with another axis") {
  const std::string tilt = "[0, " + std::to_string(kTilt) + ", 0]";
  check_equal(make_rotor("rotation = { constant = " + tilt + " }"), make_tilted());
  // The mount has come to rest there.
  check_equal(make_rotor("rotation = { time = [0, 5, 10], y = [0, " + std::to_string(kTilt) + ", " +
                         std::to_string(kTilt) + "] }"),
              make_tilted());
}

TEST_CASE("steady: a mount at constant velocity changes nothing") {
  check_equal(make_rotor("translation = { constant = [1, 2, 3], rate = [30, 0, 10] }"),
              make_rotor(""));
}

TEST_CASE("steady: a mount that goes on turning or shaking has no equilibrium") {
  const auto refusal = [](const std::string& mount) {
    return test::message_of([&] { solve_modes(make_rotor(mount)); });
  };
  const std::string expected =
      " without end, expected one that comes to rest, or translates at constant velocity, to find "
      "an equilibrium";
  CHECK(refusal("rotation = { rate = [0, 0, 1] }") ==
        "hub.mount.rotation: the mount turns" + expected);
  CHECK(refusal("rotation = { amplitude = [0, 0.1, 0], frequency = 2 }") ==
        "hub.mount.rotation: the mount oscillates" + expected);
  CHECK(refusal("translation = { rate = [1, 0, 0], amplitude = [0, 0.1, 0], frequency = 2 }") ==
        "hub.mount.translation: the mount oscillates" + expected);
}

TEST_CASE("steady: a simulation starts where its mount is") {
  const std::string start = "[initial]\nstate = \"equilibrium\"\n";
  const std::string tilt = "rotation = { constant = [0, 0.4, 0]";
  Simulation still(make_rotor(tilt + " }\ntranslation = { rate = [3, 0, 0] }", start));
  Simulation rolling(
      make_rotor(tilt + ", amplitude = [0.1, 0, 0], frequency = 3.0, phase = 0 }", start));
  const double tip = still.sensor("blade1.tip.z");
  CHECK(std::abs(tip) > 0.01);
  CHECK(rolling.sensor("blade1.tip.z") == doctest::Approx(tip).epsilon(1e-10));
  still.run_until(0.5);
  rolling.run_until(0.5);
  CHECK(std::abs(still.sensor("blade1.tip.z") - tip) < 1e-8);
  CHECK(std::abs(rolling.sensor("blade1.tip.z") - tip) > 1e-4);
}

}  // namespace spoke
