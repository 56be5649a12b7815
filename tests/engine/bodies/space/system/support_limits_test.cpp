// A support as what it must equal: the same tree as a subsystem where the rotor does not turn, a
// hub on an axle where the support does not give.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kLimitSeconds = 0.1;

std::string replace_all(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// The hub that turns with nothing, in a text as of [hub] or of a body.
const std::string kInertia = "inertia = [0.4, 0.5, 0.6]\n";
const std::string kStandingHub =
    "[hub]\naxis = [0.2, 0.3, 1.0]\nmass = 2.0\n" + kInertia + "drive = { kind = \"fixed\" }\n";
const std::string kFixedHub = "[hub]\ndrive = { kind = \"fixed\" }\n";
/// What kFuselageHub stands on, as a free hub.
const std::string kFreeHub =
    "[hub]\nsupport = \"free\"\nmass = 2.0\ninertia = [0.3, 0.3, 0.3]\n"
    "velocity = [0.3, -0.2, 0.5]\nangular_velocity = [1.5, -1.0, 2.5]\n";

/// kTower as a subsystem on the hub, with the rotor's hub as its last body, "disc".
std::string as_subsystem(const std::string& support, const std::string& base) {
  std::string tree = support.substr(support.find("[[support.body]]"));
  tree.erase(tree.find("[support.axle]"));
  tree = replace_all(replace_all(tree, "support.", "subsystem."), '"' + base + '"', "\"hub\"");
  return "[[subsystem]]\nname = \"tree\"\n" + tree +
         "[[subsystem.body]]\nname = \"disc\"\nkind = \"rigid\"\nmass = 2.0\n" + kInertia +
         "[[subsystem.joint]]\nparent = \"nacelle\"\nchild = \"disc\"\nkind = \"fixed\"\n"
         "offset = [0.1, 0.0, 0.2]\n";
}

/// A rigid pendulum on the hub, or on the body of that name.
std::string make_arm(const std::string& parent) {
  return "[[subsystem.body]]\nname = \"arm\"\nkind = \"rigid\"\nmass = 0.8\n"
         "center = [0.4, 0.0, 0.1]\ninertia = [0.03, 0.05, 0.04]\n"
         "[[subsystem.joint]]\nparent = \"" +
         parent +
         "\"\nchild = \"arm\"\nkind = \"universal\"\naxes = [[0, -1, 0], [0, 0, 1]]\n"
         "offset = [0.2, 0.1, 0.0]\nstiffness = [20.0, 30.0]\ninitial_speed = [2.0, -1.5]\n";
}
const std::string kArm = "[[subsystem]]\nname = \"arm\"\n" + make_arm("hub");

Simulation simulate_limit(const std::string& text, IntegrationMethod method,
                          Formulation formulation) {
  Scenario scenario = make_scenario(text, 1e-3, kLimitSeconds, method);
  scenario.integration.tolerance = 1e-13;
  return Simulation(scenario, {formulation, ExecutorKind::serial, 1});
}

/// What two bodies are apart, in place, velocity and a thousandth of the acceleration.
double difference_of(const MarkerState& a, const MarkerState& b) {
  return std::max({(a.position - b.position).norm(), (a.velocity - b.velocity).norm(),
                   (a.angular_velocity - b.angular_velocity).norm(),
                   1e-3 * (a.acceleration - b.acceleration).norm(),
                   1e-3 * (a.angular_acceleration - b.angular_acceleration).norm()});
}

/// Runs a rotor that does not turn on a support, and the same tree on a hub; `arms`: whether the
/// rotor is the subsystem kArm besides its hub. Checks that their bodies move alike.
void check_same(const std::string& supported, const std::string& tree, int arms) {
  for (const Formulation formulation : formulations())
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
      CAPTURE(name_of(formulation));
      CAPTURE(name_of(method));
      Simulation a = simulate_limit(supported, method, formulation);
      Simulation b = simulate_limit(tree, method, formulation);
      a.run_until(kLimitSeconds);
      b.run_until(kLimitSeconds);
      CHECK(b.marker({0, 1, 0.0}).velocity.norm() > 0.01);
      for (int body = 0; body < 3; ++body)
        CHECK(difference_of(a.marker({arms, body, 0.0}), b.marker({0, body, 0.0})) < 1e-10);
      if (arms > 0) CHECK(difference_of(a.marker({0, 0, 0.0}), b.marker({0, 3, 0.0})) < 1e-10);
    }
}

std::string without_stiffening(const std::string& text) {
  return replace_all(text, "length = 2.0\n", "length = 2.0\ngeometric_stiffening = false\n");
}

}  // namespace

TEST_CASE("a support under a rotor that does not turn is the same tree as a subsystem") {
  check_same(make_text(kStandingHub, kTower, kGravity),
             make_text(kFixedHub, as_subsystem(kTower, "ground"), kGravity), 0);
}

// The tension of a support has the rotor's mass in its mean place over a turn: without it.
TEST_CASE("a rotor of a rigid arm on a support is a branch of the tree") {
  const std::string tower = without_stiffening(kTower);
  check_same(make_text(kStandingHub, kArm + tower, kGravity),
             make_text(kFixedHub, as_subsystem(tower, "ground") + make_arm("disc"), kGravity), 1);
}

TEST_CASE("a support on a fuselage under a rotor that does not turn is the tree on a free hub") {
  const std::string tower = without_stiffening(
      replace_all(kTower.substr(kTower.find("[[support.body]]")), "\"ground\"", "\"fuselage\""));
  const std::string fuselage = kFuselageHub.substr(kFuselageHub.find("[support]"));
  check_same(make_text(kStandingHub, kArm + fuselage + tower),
             make_text(kFreeHub, as_subsystem(tower, "fuselage") + make_arm("disc")), 1);
}

namespace {

/// A blade's tip and joints at the end.
Eigen::Vector3d end_of(const std::string& text, Formulation formulation) {
  Scenario scenario = make_scenario(text, 4e-3, 0.4, IntegrationMethod::generalized_alpha);
  scenario.integration.tolerance = 1e-13;
  Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1});
  simulation.run_until(0.4);
  return {simulation.sensor("blade1.tip.x"), simulation.sensor("blade1.tip.y"),
          simulation.sensor("blade1.tip.z")};
}

std::string make_springs(double stiffness) {
  const std::string k = std::to_string(stiffness), d = std::to_string(1e-2 * stiffness);
  const auto six = [](const std::string& x) {
    return "[" + x + ", " + x + ", " + x + ", " + x + ", " + x + ", " + x + "]\n";
  };
  return "[hub.suspension]\nstiffness = " + six(k) + "damping = " + six(d) +
         "mass = 0.5\ninertia = 0.1\n";
}

}  // namespace

TEST_CASE("springs under the axle tend to the prescribed axle, by their compliance") {
  const std::string blades = kBooms + kHinges;
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    const Eigen::Vector3d expected =
        end_of(make_text(kDrivenHub, blades, kRisingGravity), formulation);
    const auto error = [&](double stiffness) {
      return (end_of(make_text(kDrivenHub, make_springs(stiffness) + blades, kRisingGravity),
                     formulation) -
              expected)
          .norm();
    };
    const double soft = error(1e5), stiff = error(1e6), stiffest = error(1e7);
    CAPTURE(soft);
    CHECK(soft > 1e-6);
    CHECK(soft / stiff == doctest::Approx(10.0).epsilon(0.1));
    CHECK(stiff / stiffest == doctest::Approx(10.0).epsilon(0.05));
  }
}

TEST_CASE("a bushing between a support's bodies tends to a fixed joint, by its compliance") {
  const auto tower = [](const std::string& joint) {
    std::string text = kTower;
    const std::size_t from = text.find("kind = \"revolute\""), to = text.find("[support.axle]");
    return text.replace(from, to - from, joint);
  };
  const auto end = [&](const std::string& joint) {
    return end_of(make_text(kDrivenHub, kBooms + tower(joint), kRisingGravity),
                  Formulation::structured);
  };
  const Eigen::Vector3d expected = end("kind = \"fixed\"\n");
  const auto error = [&](const std::string& k, const std::string& d) {
    return (end("kind = \"bushing\"\nstiffness = [" + k + ", 0, " + k + ", " + k + ", " + k + ", " +
                k + "]\ndamping = [" + d + ", 0, " + d + ", " + d + ", " + d + ", " + d + "]\n") -
            expected)
        .norm();
  };
  const double soft = error("1e5", "1e3"), stiff = error("1e6", "1e4");
  CHECK(soft > 1e-6);
  CHECK(soft / stiff == doctest::Approx(10.0).epsilon(0.1));
}

TEST_CASE("a bushing that is free in all directions lets a body fly, and spin") {
  const std::string ball =
      "[[subsystem]]\nname = \"ball\"\n[[subsystem.body]]\nname = \"ball\"\nkind = \"rigid\"\n"
      "mass = 2.0\ninertia = [0.1, 0.1, 0.15]\n[[subsystem.joint]]\nparent = \"hub\"\n"
      "child = \"ball\"\nname = \"air\"\nkind = \"bushing\"\n"
      "free = [\"x\", \"y\", \"z\", \"about x\", \"about y\", \"about z\"]\n"
      "initial_speed = [3.0, 0, 5.0, 0, 0, 7.0]\n";
  Simulation flight(make_scenario(make_text("[hub]\ndrive = { kind = \"fixed\" }\n", ball,
                                            "[gravity]\nacceleration = [0, 0, -9.81]\n"),
                                  0.01, 0.8, IntegrationMethod::rk4));
  flight.run_until(0.8);
  const int joint = flight.joint_index(0, "air");
  const auto value = [&](int c) { return flight.joint_motion(0, joint, c).value; };
  CHECK(value(0) == doctest::Approx(2.4).epsilon(1e-12));
  CHECK(value(2) == doctest::Approx(4.0 - 0.5 * 9.81 * 0.64).epsilon(1e-12));
  CHECK(value(5) == doctest::Approx(5.6).epsilon(1e-12));
  CHECK(std::abs(value(1)) + std::abs(value(3)) + std::abs(value(4)) < 1e-12);
}

TEST_CASE("a rotor on a support that does not give is the rotor on an axle, on a ship, too") {
  const std::string ship =
      "[hub.mount]\n"
      "translation = { rate = [3.0, 0.5, 0.0], amplitude = [0.2, 0.1, 0.4], frequency = 5.0 }\n"
      "rotation = { constant = [0.1, 0.0, 0.2], amplitude = [0.3, -0.2, 0.0], frequency = 4.0 }\n";
  const std::string post =
      "[support]\n[[support.body]]\nname = \"post\"\nkind = \"rigid\"\nmass = 1.0\n"
      "inertia = 0.1\n[[support.joint]]\nchild = \"post\"\nkind = \"fixed\"\n"
      "[support.axle]\nbody = \"post\"\n";
  for (const std::string& hub : {kDrivenHub, kTurnedHub})
    for (const std::string& mount : {std::string(), ship})
      for (const Formulation formulation : formulations()) {
        CAPTURE(name_of(formulation));
        CAPTURE(mount.empty());
        const auto run = [&](const std::string& support) {
          Simulation simulation =
              simulate_limit(make_text(hub + mount, kBooms + kHinges + support, kGravity),
                             IntegrationMethod::rk4, formulation);
          simulation.run_until(0.5 * kLimitSeconds);
          return simulation;
        };
        const Simulation held = run(""), standing = run(post);
        CHECK(difference_of(held.marker({0, 1, 1.0}), standing.marker({0, 1, 1.0})) < 1e-9);
        for (const char* name : {"hub.angle", "hub.speed", "hub.torque"})
          CHECK(std::abs(held.sensor(name) - standing.sensor(name)) < 1e-9);
        if (mount.empty())  // a ship moves the post, too
          CHECK(std::abs(held.sensor("energy.work") - standing.sensor("energy.work")) < 1e-9);
        CHECK((held.hub_reaction().force - standing.hub_reaction().force).norm() < 1e-8);
        CHECK((held.hub_reaction().moment - standing.hub_reaction().moment).norm() < 1e-8);
      }
}
