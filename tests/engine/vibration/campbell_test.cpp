// Follows modes over speeds: through crossings, and over gaps.

#include "engine/campbell.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "models/error.h"
#include "tests/engine/steady/blades.h"
#include "tests/message_of.h"

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

}  // namespace
}  // namespace spoke
