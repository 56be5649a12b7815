// Drives of several rotors that the program replaces between steps.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/courses.h"
#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/message_of.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kEnd = 0.3;

/// Two rotors on a carrier in springs, each with its drive.
Scenario make_driven_rotors(const std::string& main, const std::string& tail) {
  const auto rotor = [](const std::string& name, const std::string& place, const std::string& axis,
                        const std::string& drive) {
    return "[[rotor]]\nname = \"" + name + "\"\nhub = { axis = " + axis +
           ", mass = 2.0, inertia = 0.3, drive = " + drive +
           " }\naxle = { body = \"carrier\", offset = " + place +
           " }\n[rotor.blade]\ncount = 2\nlength = 2.0\nbodies = 1\nelements = 2\n"
           "[rotor.blade.sections]\nmass_per_length = 2.0\naxial_stiffness = 2e6\n"
           "flap_stiffness = 2e3\nlag_stiffness = 2e4\ntorsion_stiffness = 2e3\n";
  };
  return parse_scenario(R"(world = "space"
[integration]
step = 1e-3
duration = 0.4
[support]
from = "ground"
[[support.body]]
name = "carrier"
kind = "rigid"
mass = 20.0
inertia = 5.0
[[support.joint]]
name = "foot"
child = "carrier"
kind = "bushing"
stiffness = [2e5, 3e5, 4e5, 2e4, 3e4, 4e4]
)" + rotor("main", "[0.3, 0.2, 1]", "[0, 0, 1]", main) +
                            rotor("tail", "[-3, 0, 0.5]", "[0, 1, 0]", tail),
                        "rotors.toml");
}

const std::string kTen = "{ kind = \"constant\", speed = 10.0 }";
const std::string kTwenty = "{ kind = \"constant\", speed = 20.0 }";
const std::string kFree = "{ kind = \"free\", initial_speed = 20.0 }";

Simulation simulate(const Scenario& scenario) {
  return Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
}

/// Compares all that two simulations show.
void check_same(const Simulation& one, const Simulation& other) {
  const std::vector<double> a = values_of(one), b = values_of(other);
  REQUIRE(one.sensor_names() == other.sensor_names());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::string& name = one.sensor_names()[k];
    // Residuals, and the work of drives that differ before they are replaced, are no motions.
    if (name.starts_with("energy") || name.starts_with("momentum")) continue;
    CAPTURE(name);
    CHECK(std::abs(a[k] - b[k]) <= 1e-9 * (1.0 + std::abs(b[k])));
    largest = std::max(largest, std::abs(b[k]));
  }
  CHECK(largest > 1.0);
}

/// 20 rad/s, then in 0.1 s to 26 rad/s.
const SpeedTable kFaster{Curve({0.0, 0.1, 0.2}, {20.0, 20.0, 26.0})};

}  // namespace

TEST_CASE("drives of rotors: one that the program sets acts as that of the scenario") {
  struct Case {
    std::string before, after;  ///< drives of the scenario
    Drive set;                  ///< the latter
    double speed;               ///< to which it leads [rad/s]; 0: not compared
  };
  for (const Case& each :
       {Case{kTwenty, "{ kind = \"table\", time = [0.0, 0.1, 0.2], speed = [20.0, 20.0, 26.0] }",
             kFaster, 26.0},
        Case{kFree,
             "{ kind = \"torque\", time = [0.0, 0.1, 0.2], torque = [0.0, 0.0, -30.0], "
             "initial_speed = 20.0 }",
             TorqueDrive{Curve({0.0, 0.1, 0.2}, {0.0, 0.0, -30.0}), 20.0}, 0.0}}) {
    Simulation set = simulate(make_driven_rotors(kTen, each.before));
    Simulation given = simulate(make_driven_rotors(kTen, each.after));
    // The other has its own again, since accelerations are found anew with any.
    for (Simulation* simulation : {&set, &given}) {
      simulation->run_until(0.05);
      simulation->set_drive(each.set, "tail");
      simulation->run_until(kEnd);
    }
    CHECK(set.sensor("hub.speed") == doctest::Approx(10.0).epsilon(1e-9));
    if (each.speed > 0.0)
      CHECK(set.sensor("tail.hub.speed") == doctest::Approx(each.speed).epsilon(1e-9));
    else
      CHECK(set.sensor("tail.hub.torque") == doctest::Approx(-30.0));
    check_same(set, given);
  }
}

TEST_CASE("drives of rotors: without a name the first one's is set, by its own as well") {
  Simulation simulation = simulate(make_driven_rotors(kFree, kTwenty));
  simulation.set_drive(TorqueDrive{Curve(3.0), 20.0});
  CHECK(std::get<TorqueDrive>(simulation.drive("main")).torque.value(0.0) == 3.0);
  simulation.set_drive(TorqueDrive{Curve(4.0), 20.0}, "main");
  CHECK(std::get<TorqueDrive>(simulation.drive()).torque.value(0.0) == 4.0);
  CHECK(std::holds_alternative<ConstantSpeed>(simulation.drive("tail")));
}

TEST_CASE("drives of rotors: clones, courses and equilibria have those in force") {
  Simulation simulation = simulate(make_driven_rotors(kTen, kFree));
  const SavedState start = simulation.save();
  const Courses at_start = courses(simulation);
  REQUIRE(at_start.rotors.size() == 1);
  CHECK(at_start.rotors[0].rotor == "tail");
  const auto go_on = [](Simulation& one, double t) {
    one.run_until(t);
    return one.state_hash();
  };
  const std::uint64_t plain = go_on(simulation, 0.1);
  simulation.set_drive(TorqueDrive{Curve(-200.0), 20.0}, "tail");
  const SavedState state = simulation.save();
  const Courses in_force = courses(simulation);
  Simulation clone = simulation.clone();
  const std::uint64_t driven = go_on(simulation, 0.2);
  CHECK(go_on(clone, 0.2) == driven);
  clone.set_drive(TorqueDrive{Curve(50.0), 20.0}, "tail");
  CHECK(std::get<TorqueDrive>(simulation.drive("tail")).torque.value(0.0) == -200.0);
  simulation.restore(start);
  CHECK(go_on(simulation, 0.1) != plain);
  restore(simulation, start, at_start);
  CHECK(std::holds_alternative<FreeDrive>(simulation.drive("tail")));
  CHECK(go_on(simulation, 0.1) == plain);
  restore(simulation, state, in_force);
  CHECK(go_on(simulation, 0.2) == driven);

  Simulation faster = simulate(make_driven_rotors(kTen, kTwenty));
  faster.set_drive(kFaster, "tail");
  CHECK(solve_equilibrium(faster).rotors[1].speed == 26.0);
}

TEST_CASE("drives of rotors: jumps are said of the drive that has them") {
  Simulation simulation = simulate(make_driven_rotors(kTen, kTwenty));
  simulation.set_drive(SpeedTable{Curve({0.0, 0.1, 0.1001}, {20.0, 20.0, 26.0})}, "tail");
  REQUIRE(simulation.warnings().size() == 1);
  CHECK(simulation.warnings()[0].text.find("the drive of \"tail\" changes the speed by 6 rad/s") !=
        std::string::npos);
  simulation.set_drive(kFaster, "tail");
  CHECK(simulation.warnings().empty());
  const Scenario scenario = make_driven_rotors(
      kTen, "{ kind = \"table\", time = [0.0, 0.1, 0.1001], speed = [20.0, 20.0, 26.0] }");
  CHECK(simulate(scenario).warnings().size() == 1);
}

TEST_CASE("drives of rotors: what there is not is refused, and nothing changes") {
  Simulation simulation = simulate(make_driven_rotors(kTen, kTwenty));
  const std::uint64_t before = simulation.state_hash();
  const auto refused = [&](const Drive& drive, const std::string& rotor) {
    return message_of([&] { simulation.set_drive(drive, rotor); });
  };
  CHECK(refused(kFaster, "tial") == "the rotor of a drive is \"tial\", did you mean \"tail\"?");
  CHECK(refused(kFaster, "propeller") ==
        "the rotor of a drive is \"propeller\", expected \"main\" or \"tail\"");
  CHECK(refused(FreeDrive{}, "tail").starts_with("a drive free cannot take over from constant:"));
  CHECK(refused(kFaster, "main").find("does not go on from where the hub is") != std::string::npos);
  CHECK(message_of([&] { simulation.drive("nose"); }).starts_with("the rotor of a drive is"));
  CHECK(simulation.state_hash() == before);
  CHECK(std::holds_alternative<ConstantSpeed>(simulation.drive("tail")));
  Courses other = courses(simulation);
  other.rotors[0].drive = FreeDrive{};
  CHECK(message_of([&] {
          restore(simulation, simulation.save(), other);
        }).starts_with("the drive of \"tail\": the drive to go back to"));

  Simulation one = simulate(parse_scenario(
      "[hub]\nradius = 0.1\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\nspeed = 20.0\n"
      "[blade]\ncount = 1\nlength = 1.0\nbodies = 1\nelements = 1\ndensity = 1000.0\narea = 1e-3\n"
      "second_moment = 1e-6\nyoungs_modulus = 1e9\n[integration]\nduration = 1.0\n",
      "one.toml"));
  CHECK(message_of([&] { one.set_drive(kFaster, "tail"); }) ==
        "the rotor of a drive is \"tail\", expected no name: there is no [[rotor]]");
}
