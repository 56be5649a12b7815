// Several bodies of one subsystem on the hub: against subsystems of their own, closed forms, and
// what is conserved.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kMass = 1.5, kReach = 0.4, kSpring = 50.0, kTurned = 0.3;
constexpr double kInertia = 0.06;  // about the mass centre
constexpr double kAboutPin = kInertia + kMass * kReach * kReach;

/// A pendulum `name` on a pin at `offset` that turns about `axis`.
std::string body_text(const std::string& name) {
  return "[[subsystem.body]]\nname = \"" + name +
         "\"\nkind = \"rigid\"\nmass = 1.5\ncenter = [0.4, 0.0, 0.0]\n"
         "inertia = [0.02, 0.06, 0.06]\n";
}
std::string joint_text(const std::string& name, const std::string& place, const std::string& axis) {
  return "[[subsystem.joint]]\nname = \"" + name + "_pin\"\nparent = \"hub\"\nchild = \"" + name +
         "\"\nkind = \"revolute\"\nstiffness = 50.0\ninitial = 0.3\n" + place + "axis = " + axis +
         "\n";
}
const std::string kHere = "offset = [0.1, 0.0, 0.0]\n";
const std::string kThere = "offset = [-0.1, 0.05, 0.0]\norientation = [0.0, 0.0, 3.0]\n";

std::string one_subsystem(const std::string& axis, const std::string& here = kHere,
                          const std::string& there = kThere) {
  return "[[subsystem]]\nname = \"pair\"\n" + body_text("one") + body_text("two") +
         joint_text("one", here, axis) + joint_text("two", there, axis);
}
std::string two_subsystems(const std::string& axis) {
  return "[[subsystem]]\nname = \"first\"\n" + body_text("one") + joint_text("one", kHere, axis) +
         "[[subsystem]]\nname = \"second\"\n" + body_text("two") + joint_text("two", kThere, axis);
}

const std::string kFixedHub = "[hub.drive]\nkind = \"fixed\"\n";
const std::string kTorqueHub =
    "[hub]\ninertia = 0.5\n[hub.drive]\nkind = \"torque\"\ntorque = 0.8\n";
const std::string kFreeHub = "[hub]\nsupport = \"free\"\nmass = 2.0\ninertia = [0.3, 0.4, 0.5]\n";
const std::string kFalling = "[gravity]\nacceleration = [0.0, 0.0, -2.0]\n";
const std::string kMomentum = "[[sensor]]\nquantity = \"momentum\"\n";
const std::string kReaction = "[[sensor]]\nquantity = \"hub_reaction\"\nframe = \"hub\"\n";

Simulation simulate(const std::string& text, Formulation formulation = Formulation::structured,
                    double step = 1e-3) {
  return Simulation(make_scenario(text, step, 2.0), {formulation, ExecutorKind::serial, 1});
}

Eigen::VectorXd vector_of(const Simulation& simulation, const std::string& name,
                          const std::vector<std::string>& parts) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(parts.size()));
  for (std::size_t k = 0; k < parts.size(); ++k)
    vector[static_cast<Eigen::Index>(k)] = simulation.sensor(name + parts[k]);
  return vector;
}
Eigen::VectorXd momentum_of(const Simulation& simulation) {
  return vector_of(simulation, "momentum",
                   {".x", ".y", ".z", ".angular.x", ".angular.y", ".angular.z"});
}
Eigen::Vector3d three(const Simulation& simulation, const std::string& name) {
  return vector_of(simulation, name, {".x", ".y", ".z"});
}

}  // namespace

TEST_CASE("two pendulums of one subsystem on a hub that stands swing as one does by itself") {
  // About the vertical, at pins on the axis of the hub.
  const std::string model = one_subsystem("[0.0, 0.0, 1.0]", "", "orientation = [0.0, 0.0, 3.0]\n");
  const double frequency = std::sqrt(kSpring / kAboutPin);
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    Simulation simulation = simulate(make_text(kFixedHub, model, kFalling), formulation);
    simulation.run_until(0.9);
    const double angle = kTurned * std::cos(frequency * simulation.time());
    for (const char* name : {"pair.one_pin", "pair.two_pin"})
      CHECK(simulation.sensor(name) == doctest::Approx(angle).epsilon(1e-7));
    // The hub holds both springs, and both weights, which hang at the ends of their levers.
    CHECK(simulation.sensor("hub.torque") == doctest::Approx(-2.0 * kSpring * angle).epsilon(1e-7));
    CHECK(simulation.sensor("pair.root.force.z") == doctest::Approx(-2.0 * 2.0 * kMass));
    const Eigen::Vector2d levers =
        kReach * (Eigen::Vector2d(std::cos(angle), std::sin(angle)) +
                  Eigen::Vector2d(std::cos(angle + 3.0), std::sin(angle + 3.0)));
    CHECK(simulation.sensor("pair.root.moment.x") ==
          doctest::Approx(-2.0 * kMass * levers.y()).epsilon(1e-6));
    CHECK(simulation.sensor("pair.root.moment.y") ==
          doctest::Approx(2.0 * kMass * levers.x()).epsilon(1e-6));
  }
}

TEST_CASE("bodies of one subsystem on the hub move as those of subsystems of their own") {
  const std::string axis = "[0.0, 1.0, 0.4]";
  for (const std::string& hub : {kFixedHub, kTorqueHub, kFreeHub, kDrivenHub})
    for (const Formulation formulation : formulations()) {
      CAPTURE(hub);
      CAPTURE(name_of(formulation));
      const std::string more = kFalling + kMomentum + kReaction;
      Simulation one = simulate(make_text(hub, one_subsystem(axis), more), formulation);
      Simulation two = simulate(make_text(hub, two_subsystems(axis), more), formulation);
      for (Simulation* simulation : {&one, &two}) simulation->run_until(0.5);
      const auto check = [&](const std::string& name, const std::string& same) {
        CAPTURE(name);
        CHECK(one.sensor(name) == doctest::Approx(two.sensor(same)).epsilon(1e-9));
      };
      check("pair.one_pin", "first.one_pin");
      check("pair.two_pin", "second.two_pin");
      for (const char* name : {"hub.angle", "hub.speed", "hub.torque", "energy.kinetic",
                               "energy.strain", "hub_reaction.force.z", "hub_reaction.moment.x"})
        check(name, name);
      CHECK((momentum_of(one) - momentum_of(two)).norm() < 1e-9);
      // Both roots, about the origin of the first body.
      const Eigen::Vector3d force = three(two, "second.root.force"), from(-0.2, 0.05, 0.0);
      const Eigen::Vector3d moment =
          three(two, "first.root.moment") + three(two, "second.root.moment") + from.cross(force);
      CHECK((three(one, "pair.root.force") - three(two, "first.root.force") - force).norm() < 1e-8);
      if (hub != kDrivenHub) CHECK((three(one, "pair.root.moment") - moment).norm() < 1e-8);
    }
}

TEST_CASE("a torque gives a hub with a forest its impulse, and a free one keeps its momentum") {
  const std::string model = one_subsystem("[0.0, 1.0, 0.4]");
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    Simulation turned = simulate(make_text(kTorqueHub, model, kFalling + kMomentum), formulation);
    turned.run_until(0.5);
    CHECK(turned.sensor("momentum.angular.z") == doctest::Approx(0.8 * 0.5).epsilon(1e-9));
    Simulation flying = simulate(make_text(kFreeHub, model, kMomentum), formulation);
    const Eigen::VectorXd before = momentum_of(flying);
    flying.run_until(0.5);
    CHECK((momentum_of(flying) - before).norm() < 1e-9);
    CHECK(std::abs(flying.sensor("pair.one_pin") - kTurned) > 0.1);
  }
}

TEST_CASE("modes of a forest are those of subsystems of their own") {
  const std::string axis = "[0.0, 1.0, 0.4]";
  // By a stiff and a soft spring; two alike would share a root.
  const auto soften = [](std::string text) {
    return text.replace(text.rfind("stiffness = 50.0"), 16, "stiffness = 20.0");
  };
  for (const std::string& hub : {kTorqueHub, kFreeHub}) {
    CAPTURE(hub);
    const int count = hub == kFreeHub ? 8 : 3;
    const auto solve = [&](const std::string& bodies) {
      Scenario scenario = make_scenario(make_text(hub, soften(bodies)), 1e-3, 1.0);
      return solve_modes(scenario, {.state = {.speed = 0.0}, .count = count}).modes;
    };
    const std::vector<Mode> one = solve(one_subsystem(axis)), two = solve(two_subsystems(axis));
    REQUIRE(one.size() == two.size());
    CHECK(two.back().frequency > 10.0);
    for (std::size_t k = 0; k < one.size(); ++k)
      CHECK(std::abs(one[k].eigenvalue - two[k].eigenvalue) < 1e-5);
  }
}

TEST_CASE("a mode of a forest is named by the axes of the body that moves") {
  // Both turn about their own z axes: lag, whichever way they point.
  const std::string model =
      one_subsystem("[0.0, 0.0, 1.0]", kHere, "orientation = [0.0, 0.0, 1.5707963267948966]\n");
  Scenario scenario = make_scenario(make_text(kFixedHub, model), 1e-3, 1.0);
  for (spatial::SubsystemJoint& joint : scenario.space->subsystems[0].joints)
    joint.joint.coordinates[0].initial = 0.0;
  scenario.space->subsystems[0].joints[0].joint.coordinates[0].stiffness = 30.0;
  const std::vector<Mode> modes =
      solve_modes(scenario, {.state = {.speed = 0.0}, .count = 2}).modes;
  CHECK(modes.at(0).kind == "one_pin lag");
  CHECK(modes.at(0).frequency == doctest::Approx(std::sqrt(30.0 / kAboutPin)));
  CHECK(modes.at(1).kind == "two_pin lag");
  CHECK(modes.at(1).frequency == doctest::Approx(std::sqrt(kSpring / kAboutPin)));
}
