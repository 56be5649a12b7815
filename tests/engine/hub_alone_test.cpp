// Tests a hub without blades: a rigid body that flies, or a flywheel.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/reader/scenario_check.h"
#include "tests/message_of.h"

using namespace spoke;
using doctest::Approx;

namespace {

const std::string kFlyer = R"(
world = "space"
[hub]
support = "free"
mass = 2.0
inertia = [2.0, 2.0, 1.0]
velocity = [1.0, -2.0, 0.5]
angular_velocity = [0.3, 0.0, 2.0]
[[hub_load]]
force = [0.0, 0.0, 3.0]
frame = "inertial"
[[sensor]]
quantity = "momentum"
[integration]
duration = 2.0
step = 0.001
)";

const std::string kFlywheel = R"(
[hub]
inertia = 3.0
[hub.drive]
kind = "torque"
torque = 1.5
initial_speed = 1.0
[integration]
duration = 2.0
)";

Simulation make(const std::string& text, Formulation formulation) {
  return Simulation(parse_scenario(text, "f.toml"), {formulation, ExecutorKind::serial, 1});
}

double value_of(const std::string& name, const Simulation& simulation) {
  return simulation.sensor_values()[simulation.sensor_index(name)];
}

}  // namespace

TEST_CASE("a free hub alone flies and turns as a rigid body") {
  for (const Formulation formulation : formulations()) {
    Simulation simulation = make(kFlyer, formulation);
    simulation.run_until(2.0);
    CHECK(value_of("hub.x", simulation) == Approx(2.0).epsilon(1e-9));
    CHECK(value_of("hub.y", simulation) == Approx(-4.0).epsilon(1e-9));
    CHECK(value_of("hub.z", simulation) == Approx(0.5 * 2.0 + 0.5 * 1.5 * 4.0).epsilon(1e-9));
    // The angular momentum about the centre stays; about the origin the motion of the centre adds.
    CHECK(value_of("energy.residual", simulation) == Approx(0.0).epsilon(1e-5));
    CHECK(value_of("momentum.z", simulation) == Approx(2.0 * 0.5 + 3.0 * 2.0).epsilon(1e-9));
    const double L = 2.0 * 0.3;  // about the body's axis x at t = 0, without that of the orbit
    const double orbit = 2.0 * (value_of("hub.y", simulation) * (0.5 + 1.5 * 2.0) -
                                value_of("hub.z", simulation) * -2.0);
    CHECK(value_of("momentum.angular.x", simulation) - orbit == Approx(L).epsilon(1e-5));
  }
}

TEST_CASE("a hub alone on an axle turns as its torque says") {
  for (const Formulation formulation : formulations()) {
    Simulation simulation = make(kFlywheel, formulation);
    simulation.run_until(2.0);
    CHECK(value_of("hub.speed", simulation) == Approx(1.0 + 0.5 * 2.0).epsilon(1e-9));
    CHECK(value_of("hub.angle", simulation) == Approx(2.0 + 0.5 * 0.5 * 4.0).epsilon(1e-9));
    CHECK(simulation.linear_properties().highest_frequency == 0.0);
    CHECK(std::isinf(simulation.linear_properties().rk4_largest_step));
    CHECK(simulation.hub_reaction().moment.z() == Approx(1.5));
  }
}

TEST_CASE("a hub alone has modes: it moves as it likes") {
  const ModesResult modes = solve_modes(parse_scenario(kFlywheel, "f.toml"), {{1.0}, 1});
  REQUIRE(modes.modes.size() == 1);
  CHECK(modes.modes[0].frequency == 0.0);
  CHECK(modes.modes[0].of == "all");
}

TEST_CASE("a hub whose motion is prescribed needs blades, and what is on blades does, too") {
  const auto message = [](const std::string& text) {
    return message_of([&] { parse_scenario(text, "f.toml"); });
  };
  const std::string driven =
      "[hub.drive]\nkind = \"constant\"\nspeed = 1\n[integration]\nduration = 1\n";
  CHECK(message(driven) == "f.toml:1:1: blade: is missing, expected [blade] or [[blades]]");
  CHECK(message("world = \"space\"\n" + driven) ==
        "f.toml:1:1: blade: is missing, expected [blade], [[blades]] or [[subsystem]]");
  CHECK(message(kFlywheel + "[[load]]\nforce = [1, 0]\n") ==
        "f.toml:10:1: load: is on blades, of which there are none");
  CHECK(message(kFlywheel + "[[drag]]\nlinear = 1\n") ==
        "f.toml:10:1: drag: is on blades, of which there are none");
  CHECK(message(kFlywheel + "[[sensor]]\nquantity = \"velocity\"\n") ==
        "f.toml:10:1: sensor.1: is on blades, of which there are none");
  Scenario filled = parse_scenario(kFlywheel, "f.toml");
  filled.rotor.loads.emplace_back();
  CHECK(message_of([&] { check_scenario(filled); }) ==
        "load: is on blades, of which there are none");
}

TEST_CASE("the work on a hub with its mass off the axle is its energy, by any formulation") {
  // A speck of mass is the blade. Gravity is across the axle, its work counts, and the steps are
  // long.
  const std::string text = R"(
world = "space"
[hub]
mass = 4.0
center = [0.3, 0.1, 0.0]
inertia = 2.0
[hub.drive]
kind = "spin_up"
speed = 5.0
ramp = 0.8
[gravity]
acceleration = [0.0, -9.81, 0.0]
[[subsystem]]
name = "s"
body = [{ name = "speck", kind = "rigid", mass = 1e-9, inertia = 1e-9 }]
joint = [{ parent = "hub", child = "speck", kind = "fixed" }]
[integration]
step = 0.02
duration = 0.8
)";
  const double inertia = 2.0 + 4.0 * (0.3 * 0.3 + 0.1 * 0.1);  // about the axle
  for (const Formulation formulation : formulations()) {
    Simulation simulation = make(text, formulation);
    simulation.run_until(0.8);
    CHECK(value_of("energy.work", simulation) == Approx(0.5 * inertia * 25.0).epsilon(1e-7));
    CHECK(std::abs(value_of("energy.residual", simulation)) < 1e-6);
  }
}
