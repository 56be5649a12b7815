// Tests equilibria that are known in closed form or from publications, and models that cannot stand
// still.

#include "engine/equilibrium.h"

#include <doctest/doctest.h>

#include <cmath>

#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using test::make_planar;
using test::make_spatial;

std::string tip_force(double y, const char* frame = "inertial") {
  return "[[load]]\nframe = \"" + std::string(frame) + "\"\nforce = [0.0, " + std::to_string(y) +
         "]\n";
}

TEST_CASE("equilibrium: a cantilever under a dead force at its tip is an elastica") {
  // Mattiasson 1981, Int. J. Numer. Meth. Engng 17, 145-153: P L^2/EI, and at the tip slope,
  // deflection and shortening by the length.
  struct Elastica {
    double load, slope, deflection, shortening;
  };
  for (const Elastica& known :
       {Elastica{1.0, 0.46135, 0.30172, 0.05643}, Elastica{2.0, 0.78175, 0.49346, 0.16064},
        Elastica{3.0, 0.98602, 0.60325, 0.25442}}) {
    const EquilibriumResult result = solve_equilibrium(
        make_planar({.bodies = 16, .elements = 2, .more = tip_force(known.load)}));
    const BladeEquilibrium& blade = result.blades.at(0);
    CHECK(blade.tip_rotation.z() == doctest::Approx(known.slope).epsilon(1e-3));
    CHECK(blade.rotations.back().z() == doctest::Approx(known.slope).epsilon(1e-3));
    CHECK(blade.tip_displacement.y() == doctest::Approx(known.deflection).epsilon(1e-3));
    CHECK(-blade.tip_displacement.x() == doctest::Approx(known.shortening).epsilon(2e-3));
    // Clamped: the force, and its moment about the deformed root.
    CHECK(blade.loads.front().force.y() == doctest::Approx(known.load).epsilon(1e-9));
    CHECK(result.hub_force.y() == doctest::Approx(-known.load).epsilon(1e-9));
    // The force acts at the foreshortened tip.
    CHECK(result.hub_moment.z() ==
          doctest::Approx(-known.load * (1.0 - known.shortening)).epsilon(1e-3));
  }
}

TEST_CASE("equilibrium: steady rotation stretches a blade by tan(kL)/k - L") {
  // EA u'' + m w^2 (x + u) = 0, u(0) = u'(L) = 0, k^2 = m w^2/EA.
  const double speed = 2.0, EA = 100.0, k = speed / std::sqrt(EA);
  for (const Scenario& scenario : {make_planar({.elements = 8, .axial_stiffness = EA}),
                                   make_spatial({.elements = 8, .axial_stiffness = EA})}) {
    const EquilibriumResult result = solve_equilibrium(scenario, {.speed = speed});
    const double stretch = result.blades.at(0).tip_displacement.norm();
    CHECK(stretch == doctest::Approx(std::tan(k) / k - 1.0).epsilon(2e-3));
  }
}

TEST_CASE("equilibrium: what has none is refused in a line") {
  Scenario free = make_planar({});
  free.rotor.hub.support = HubSupport::free;
  free.rotor.hub.mass = 1.0;
  CHECK(test::message_of<InputError>([&] { solve_equilibrium(free); }) ==
        "hub.support: the hub is free, expected an axle: nothing holds the model");
  Scenario torque = make_planar({});
  torque.rotor.hub.drive = TorqueDrive{Curve(1.0), 0.0};
  CHECK(
      test::message_of<InputError>([&] { solve_equilibrium(torque); }) ==
      "hub.drive: a torque has no steady speed by itself, expected a speed to be given (--speed)");
  CHECK(test::message_of<InputError>([&] { solve_equilibrium(make_planar({}), {.speed = NAN}); }) ==
        "the speed is nan, expected a finite number (rad/s)");
  CHECK(test::message_of<InputError>([&] {
          solve_equilibrium(make_planar({}), {.speed = 1e308});
        }) == "the speed is 1e+308, expected 0 or a magnitude from 1e-40 to 1e+30 (rad/s)");
}

/// A pendulum of 2 kg at 0.5 m on a hinge with a damper, 0.3 rad off its upright place.
Scenario make_pendulum(double gravity, double damping) {
  return parse_scenario(
      "world = \"space\"\n[hub]\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\n"
      "speed = 0.0\n[gravity]\nacceleration = [" +
          std::to_string(gravity) +
          ", 0, 0]\n[[subsystem]]\nname = \"p\"\n[[subsystem.body]]\nname = \"rod\"\n"
          "kind = \"rigid\"\nmass = 2.0\ncenter = [0.5, 0, 0]\ninertia = [0.1, 0.1, 0.1]\n"
          "[[subsystem.joint]]\nname = \"hinge\"\nparent = \"hub\"\nchild = \"rod\"\n"
          "kind = \"revolute\"\naxis = [0, 1, 0]\ninitial = 0.3\ndamping = " +
          std::to_string(damping) + "\n[integration]\nduration = 1.0\n",
      "pendulum.toml");
}

TEST_CASE("equilibrium: says whether small motions decay") {
  const double w = std::sqrt(2.0 * 9.81 * 0.5 / (0.1 + 2.0 * 0.25));  // sqrt(m g l/J)
  const EquilibriumResult upright = solve_equilibrium(make_pendulum(-9.81, 0.0));
  CHECK(upright.blades.at(0).joints.at(0).value == doctest::Approx(0.0).epsilon(1e-9));
  REQUIRE(upright.stability);
  CHECK(upright.stability->motions == SmallMotions::grow);
  CHECK(upright.stability->rate == doctest::Approx(w).epsilon(1e-6));
  CHECK(upright.stability->of == "p");
  const EquilibriumResult hanging = solve_equilibrium(make_pendulum(9.81, 0.0));
  REQUIRE(hanging.stability);
  CHECK(hanging.stability->motions == SmallMotions::persist);
  CHECK(hanging.stability->frequency == doctest::Approx(w).epsilon(1e-6));
  const EquilibriumResult damped = solve_equilibrium(make_pendulum(9.81, 0.12));
  REQUIRE(damped.stability);
  CHECK(damped.stability->motions == SmallMotions::decay);
  CHECK(damped.stability->rate == doctest::Approx(-0.12 / (2.0 * 0.6)).epsilon(1e-6));
}

}  // namespace
}  // namespace spoke
