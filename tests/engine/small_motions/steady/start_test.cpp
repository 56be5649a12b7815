// Simulations that start at an equilibrium: they stay there, whatever integrates them.

#include "models/start.h"

#include <doctest/doctest.h>

#include <string>

#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using test::make_planar;
using test::make_spatial;

/// Loads that bend the blade, and rise from nothing.
const std::string kPlanarLoads =
    "[[load]]\nframe = \"hub\"\nforce = [0.0, 0.2]\nramp = 3.0\n[initial]\nstate = "
    "\"equilibrium\"\n";
const std::string kSpatialLoads =
    "[[load]]\nframe = \"hub\"\nforce = [0.0, 0.1, 0.2]\nramp = 3.0\n[gravity]\nacceleration = "
    "[0.0, 0.0, -0.3]\nramp = 2.0\n[initial]\nstate = \"equilibrium\"\n";
const std::string kHinge =
    "[[blades.joint]]\nname = \"ball\"\nstation = 0.0\nkind = \"spherical\"\nstiffness = 3.0\n";

/// Sets a speed of 2, reached in a spin-up that is over.
void turn(Drive& drive) { drive = SpinUp{2.0, 5.0}; }

Scenario planar() {
  Scenario scenario = make_planar({.bodies = 2, .axial_stiffness = 1e4, .more = kPlanarLoads});
  turn(scenario.rotor.hub.drive);
  return scenario;
}
Scenario spatial() {
  Scenario scenario = make_spatial({.bodies = 2,
                                    .elements = 2,
                                    .radius = 0.1,
                                    .axial_stiffness = 1e4,
                                    .joint = kHinge,
                                    .more = kSpatialLoads});
  turn(scenario.space->hub.drive);
  return scenario;
}

/// Returns the largest motion of the first blade's tip in the frame of the hub, by the length of
/// the blade, 1.
double move(Scenario scenario, double duration, double step, const SimulationOptions& options) {
  scenario.integration.duration = duration;
  scenario.integration.step = step;
  scenario.integration.tolerance = 1e-13;
  Simulation simulation(scenario, options);
  const std::size_t count = scenario.space ? 3 : 2;  // the first columns
  const std::vector<double> start(
      simulation.sensor_values().begin(),
      simulation.sensor_values().begin() + static_cast<std::ptrdiff_t>(count));
  CHECK(simulation.sensor_names()[0] == "blade1.tip.x");
  double largest = 0.0;
  simulation.run_until(duration, [&](double, std::span<const double> values) {
    for (std::size_t k = 0; k < count; ++k)
      largest = std::max(largest, std::abs(values[k] - start[k]));
  });
  return largest;
}

TEST_CASE("start: a rotor in steady rotation stays where its equilibrium is") {
  for (const Scenario& scenario : {planar(), spatial()})
    for (const Formulation formulation :
         {Formulation::augmented, Formulation::subsystem, Formulation::structured}) {
      CAPTURE(name_of(formulation));
      const double duration = formulation == Formulation::structured ? 10.0 : 0.5;
      CHECK(move(scenario, duration, 0.01, {.formulation = formulation}) < 1e-8);
    }
  Scenario explicitly = planar();
  explicitly.integration.method = IntegrationMethod::rk4;
  CHECK(move(explicitly, 0.2, 2e-4, {}) < 1e-8);
}

TEST_CASE("start: the state is that of spoke static, bent and turned, and can be saved") {
  for (Scenario scenario : {planar(), spatial()}) {
    Simulation simulation(scenario);
    const EquilibriumResult known = solve_equilibrium(simulation);
    CHECK(known.speed == 2.0);
    CHECK(known.blades[0].tip_displacement.norm() > 0.01);
    CHECK(simulation.sensor("blade1.tip.y") ==
          doctest::Approx(known.blades[0].tip_displacement.y()).epsilon(1e-9));
    CHECK(simulation.sensor("hub.speed") == 2.0);
    CHECK(simulation.scenario().initial.state == InitialState::equilibrium);
    simulation.step();
    const SavedState saved = simulation.save();
    simulation.step();
    // The way to a state does not matter to it, only that all ramps are over.
    scenario.initial.speed = 2.0;
    Simulation other(scenario);
    other.restore(saved);
    other.step();
    CHECK(other.state_hash() == simulation.state_hash());
  }
}

TEST_CASE("start: a spin-up can begin at the equilibrium at rest") {
  Scenario scenario = spatial();
  scenario.initial.speed = 0.0;
  const Simulation simulation(scenario);
  CHECK(simulation.sensor("hub.speed") == 0.0);
  CHECK(
      simulation.sensor("blade1.tip.z") ==
      doctest::Approx(solve_equilibrium(scenario, {.speed = 0.0}).blades[0].tip_displacement.z()));
}

TEST_CASE("start: what acts at first counts, not what follows") {
  Scenario scenario = planar();
  scenario.rotor.loads[0].factor = Curve({0.0, 1.0}, {0.0, 1.0});
  CHECK(std::abs(Simulation(scenario).sensor("blade1.tip.y")) < 1e-12);
}

TEST_CASE("start: a torque's rotor turns at the speed given, a coasting one at its own") {
  Scenario scenario = planar();
  scenario.rotor.hub.drive = TorqueDrive{Curve(1.0), 0.0};
  scenario.initial.speed = 3.0;
  CHECK(Simulation(scenario).sensor("hub.speed") == 3.0);
  scenario.rotor.hub.drive = FreeDrive{1.5};
  scenario.initial.speed.reset();
  CHECK(Simulation(scenario).sensor("hub.speed") == 1.5);
}

TEST_CASE("start: bad input is refused where it stands") {
  const auto message = [](const std::string& drive, const std::string& initial) {
    const std::string text = "[hub.drive]\n" + drive +
                             "\n[blade]\ncount = 1\nlength = 1.0\ndensity = 1.0\narea = 1.0\n"
                             "second_moment = 1e-6\nyoungs_modulus = 1e6\n[integration]\n"
                             "duration = 1.0\n[initial]\n" +
                             initial;
    return test::message_of([&] { parse_scenario(text, "a.toml"); });
  };
  const std::string steady = "state = \"equilibrium\"\n",
                    torque = "kind = \"torque\"\ntorque = 1.0";
  const std::string way_out = "; --set initial={} starts without equilibrium";
  CHECK(message(torque, steady)
            .ends_with("initial.speed: is missing, expected a speed: a torque "
                       "has no steady one by itself" +
                       way_out));
  CHECK(message(torque + "\ninitial_speed = 2.0", steady + "speed = 2.0") ==
        "a.toml:16:9: initial.speed: given along with hub.drive.initial_speed, expected only one "
        "of them" +
            way_out);
  CHECK(message("kind = \"spin_up\"\nspeed = 2.0\nramp = 1.0", steady + "speed = 1.0") ==
        "a.toml:16:9: initial.speed: is 1, expected a speed that the drive has: 0 at its start, or "
        "2 after its ramp (rad/s)" +
            way_out);
  CHECK(message("kind = \"fixed\"", "speed = 1.0") ==
        "a.toml:13:9: initial.speed: would be ignored, expected only with an equilibrium");
  CHECK(message("kind = \"fixed\"", "state = \"steady\"") ==
        "a.toml:13:9: initial.state: is \"steady\", expected \"undeformed\" or \"equilibrium\"");
  Scenario loose = make_spatial({.joint = "[[blades.joint]]\nkind = \"revolute\"\nstation = 0.0\n"
                                          "axis = [0.0, -1.0, 0.0]\n",
                                 .more = "[initial]\nstate = \"equilibrium\"\n"});
  CHECK(test::message_of([&] { Simulation{loose}; })
            .ends_with("nothing holds it, expected a spring, rotation, or gravity that does" +
                       way_out));
  loose.space->blades[0].joints[0].joint.coordinates[0].initial_speed = 1.0;
  CHECK(test::message_of([&] { Simulation{loose}; }) ==
        "initial.state: is an equilibrium, but a joint has an initial_speed, expected only one of "
        "them" +
            way_out);
  loose.initial = {};  // what the way out does
  CHECK_NOTHROW(Simulation{loose});
}

}  // namespace
}  // namespace spoke
