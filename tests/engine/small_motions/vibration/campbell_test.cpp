// Follows modes over speeds: through crossings, and over gaps.

#include "engine/campbell.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

using test::make_planar;
using test::make_spatial;

TEST_CASE(
    "campbell: modes keep their shapes through a crossing, and crossings are where they say") {
  // A blade that is stiffer in lag than in flap at rest: flap rises faster and crosses it.
  Scenario scenario = make_spatial({.bodies = 2});
  for (double& value : scenario.space->blades[0].beam.sections.lag_stiffness) value = 3.0;
  CampbellOptions options{.count = 4, .harmonics = 3};
  for (int k = 0; k <= 8; ++k) options.speeds.push_back(k);
  const CampbellResult result = solve_campbell(scenario, options);
  REQUIRE(result.branches.size() == 4);
  for (const CampbellBranch& branch : result.branches) {
    CAPTURE(branch.name);
    double before = 0.0;
    for (std::size_t k = 0; k < options.speeds.size(); ++k) {
      REQUIRE(branch.modes[k]);
      const Mode& mode = result.states[k].modes[*branch.modes[k]];
      CHECK(mode.name == branch.name);
      CHECK(mode.frequency > before);
      before = mode.frequency;
    }
  }
  CHECK(result.branches[0].name == "flap 1");
  CHECK(result.branches[1].name == "lag 1");
  const std::size_t last = options.speeds.size() - 1;
  CHECK(*result.branches[0].modes[last] > *result.branches[1].modes[last]);
  // The line of the second harmonic meets lag 1.
  const auto crossing =
      std::find_if(result.crossings.begin(), result.crossings.end(),
                   [](const auto& found) { return found.branch == 1 && found.harmonic == 2; });
  REQUIRE(crossing != result.crossings.end());
  const ModesResult there =
      solve_modes(scenario, {.state = {.speed = crossing->speed}, .count = 2});
  CHECK(there.modes.at(1).name == "lag 1");
  CHECK(there.modes.at(1).frequency == doctest::Approx(2.0 * crossing->speed).epsilon(1e-2));
  // One thread yields the same.
  options.threads = 1;
  const CampbellResult serial = solve_campbell(scenario, options);
  for (std::size_t k = 0; k < options.speeds.size(); ++k)
    for (std::size_t m = 0; m < serial.states[k].modes.size(); ++m)
      CHECK(serial.states[k].modes[m].eigenvalue == result.states[k].modes[m].eigenvalue);
}

TEST_CASE("campbell: speeds without equilibrium are gaps, of which not all may be") {
  // EA u'' + m w^2 (x + u) = 0 has no end beyond w = pi/2 sqrt(EA/m)/L.
  const Scenario soft = make_planar({.bodies = 2, .elements = 2, .axial_stiffness = 1.0});
  const CampbellResult result = solve_campbell(soft, {.speeds = {0.0, 0.5, 1.0, 1.75}, .count = 2});
  REQUIRE(result.gaps.size() == 1);
  CHECK(result.gaps[0].speed == 3);
  CHECK(result.gaps[0].reason.starts_with("no equilibrium found at 1.75 rad/s: blade 1 / "));
  CHECK(result.states[3].modes.empty());
  CHECK(result.states[3].equilibrium.speed == 1.75);
  REQUIRE(result.branches.size() == 2);
  for (const CampbellBranch& branch : result.branches) {
    CHECK(branch.modes[2]);
    CHECK_FALSE(branch.modes[3]);
  }
  const auto solve = [&](std::vector<double> speeds) {
    solve_campbell(soft, {.speeds = std::move(speeds), .count = 2});
  };
  CHECK(solve_campbell(soft, {.speeds = {-1.75, 0.0, 0.5}, .count = 2}).gaps.size() == 1);
  CHECK(test::message_of<DivergenceError>([&] {
          solve({0.0, 1.75});
        }).starts_with("no equilibrium found at 1.75 rad/s"));
}

/// Returns a rotor of three blades on a mast that rocks in two directions, all of random stiffness.
Scenario make_random_rotor(std::mt19937& dice) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto between = [&](double least, double most) {
    return std::to_string(least * std::pow(most / least, uniform(dice)));
  };
  const auto rocking = [&](const char* parent, const char* child, const char* axis) {
    return std::string("[[support.joint]]\n") +
           (*parent ? "parent = \"" + std::string(parent) + "\"\n" : "") + "child = \"" + child +
           "\"\nkind = \"revolute\"\naxis = " + axis + "\nstiffness = " + between(30.0, 600.0) +
           "\n";
  };
  const std::string text =
      "world = \"space\"\n[hub]\nmass = 1\ninertia = 0.1\n"
      "[hub.drive]\nkind = \"constant\"\nspeed = 1\n[support]\nfrom = \"ground\"\n"
      "[[support.body]]\nname = \"foot\"\nkind = \"rigid\"\nmass = 2\ninertia = 1\n"
      "[[support.body]]\nname = \"mast\"\nkind = \"rigid\"\nmass = 5\ninertia = 1\n"
      "center = [0, 0, 0.5]\n" +
      rocking("", "foot", "[0, 1, 0]") + rocking("foot", "mast", "[1, 0, 0]") +
      "[support.axle]\nbody = \"mast\"\noffset = [0, 0, 1]\n[blade]\ncount = 3\nlength = 2\n"
      "bodies = 1\nelements = 2\n[blade.sections]\nmass_per_length = 1\naxial_stiffness = 1e5\n"
      "flap_stiffness = " +
      between(5.0, 50.0) + "\nlag_stiffness = " + between(10.0, 200.0) +
      "\ntorsion_stiffness = 100\n[integration]\nduration = 1\n";
  return parse_scenario(text, "rotor.toml");
}

TEST_CASE("campbell: branches of coarse and fine rows of speeds agree") {
  // At higher speeds ground resonance begins: roots that have become one do not know which they
  // were.
  std::mt19937 dice{52};
  int compared = 0;
  for (int model = 0; model < 4; ++model) {
    CAPTURE(model);
    const Scenario rotor = make_random_rotor(dice);
    const auto solve = [&](int steps) {
      CampbellOptions options{.count = 6};
      for (int k = 0; k <= steps; ++k) options.speeds.push_back(4.0 * k / steps);
      return solve_campbell(rotor, options);
    };
    const CampbellResult coarse = solve(2), fine = solve(16);
    REQUIRE(coarse.branches.size() == 6);
    for (std::size_t b = 0; b < 6; ++b)
      for (const std::size_t k : {1u, 2u}) {
        CAPTURE(b);
        CAPTURE(k);
        const auto& rough = coarse.branches[b].modes[k];
        const auto& smooth = fine.branches[b].modes[8 * k];
        if (!rough || !smooth) continue;
        CHECK(coarse.states[k].modes[*rough].frequency ==
              doctest::Approx(fine.states[8 * k].modes[*smooth].frequency).epsilon(1e-6));
        ++compared;
      }
    for (const CampbellLoss& loss : coarse.losses)
      CHECK_FALSE(coarse.branches[loss.branch].modes[loss.lost]);
  }
  CHECK(compared > 40);  // of 48: few branches leave the lowest modes
}

TEST_CASE("campbell: a branch goes on as the mode of its name, with any number of modes") {
  // The whirls of blades on a tower are standing patterns at rest. Names do not hang on following.
  const Scenario turbine = test::read_shipped("nrel_5mw_turbine");
  const CampbellResult found = solve_campbell(turbine, {.speeds = {0.0, 0.2}, .count = 5});
  const ModesResult there = solve_modes(turbine, {.state = {0.2}, .count = 9});
  const auto expected = std::find_if(there.modes.begin(), there.modes.end(), [](const Mode& mode) {
    return mode.name == "flap 1 regressive";
  });
  REQUIRE(expected != there.modes.end());
  REQUIRE(found.branches.size() == 5);
  CHECK(found.states[0].modes[*found.branches[3].modes[0]].name == "flap 1 sine");
  REQUIRE(found.branches[3].modes[1]);
  const Mode& end = found.states[1].modes[*found.branches[3].modes[1]];
  CHECK(end.name == "flap 1 regressive");
  CHECK(end.frequency == doctest::Approx(expected->frequency).epsilon(1e-8));
  CHECK(found.losses.empty());
}

}  // namespace
}  // namespace spoke
