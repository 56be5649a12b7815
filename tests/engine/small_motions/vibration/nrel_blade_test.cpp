// Compares the first frequencies of the blade of the NREL 5 MW turbine with published ones.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/modes.h"
#include "models/scenario.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

/// First flap and first edge frequency [Hz].
struct Pair {
  double flap = 0.0, edge = 0.0;
};

/// The rated speed of 12.1 rpm [rad/s].
constexpr double kRated = 12.1 * std::numbers::pi / 30.0;

/// Reads the shipped rotor without weight: its blades are then alike at rest, too.
Scenario read_rotor(int bodies = 4, int elements = 4) {
  return test::read_shipped(
      "nrel_5mw_rotor", {"gravity.acceleration=[0, 0, 0]", "blade.bodies=" + std::to_string(bodies),
                         "blade.elements=" + std::to_string(elements)});
}

/// Reads the rotor with the masses of table 2-1 of the report, which the shipped rotor scales.
Scenario read_light_rotor() {
  Scenario scenario = read_rotor();
  for (spatial::Blade& blade : scenario.space->blades)
    for (std::vector<double>* masses :
         {&blade.beam.sections.mass_per_length, &blade.beam.sections.flap_inertia,
          &blade.beam.sections.lag_inertia})
      for (double& mass : *masses) mass /= 1.053147;
  return scenario;
}

double find_frequency(const ModesResult& result, const std::string& name) {
  const auto mode = std::find_if(result.modes.begin(), result.modes.end(),
                                 [&](const Mode& m) { return m.name == name; });
  REQUIRE(mode != result.modes.end());
  return mode->frequency / (2.0 * std::numbers::pi);
}

Pair find_pair(const Scenario& scenario, double speed) {
  const ModesResult result = solve_modes(scenario, {.state = {.speed = speed}, .count = 3});
  REQUIRE_FALSE(result.are_blades_coupled);
  return {find_frequency(result, "flap 1"), find_frequency(result, "lag 1")};
}

void check_within(double share, const Pair& found, const Pair& known) {
  CHECK(found.flap == doctest::Approx(known.flap).epsilon(share));
  CHECK(found.edge == doctest::Approx(known.edge).epsilon(share));
}

}  // namespace

TEST_CASE("published: the NREL 5 MW blade at rest") {
  const Pair found = find_pair(read_rotor(), 0.0);
  // Jonkman et al., NREL/TP-500-38060 (2009), table 9-1, of the whole turbine with its rotor
  // locked: asymmetric modes about the pitch axis, in which hub and nacelle hardly move. By FAST,
  // then by ADAMS.
  check_within(0.02, found, {0.6675, 1.0793});
  check_within(0.02, found, {0.6686, 1.0740});
}

TEST_CASE("published: the NREL 5 MW blade at 12.1 rpm") {
  const Pair found = find_pair(read_light_rotor(), kRated);
  // BeamDyn, regression test 5MW_Land_BD_Linear of OpenFAST, frequencies.txt: the blades' own
  // linear models at azimuths 0, 120 and 240 degrees, whose mean is free of the weight.
  check_within(0.01, found,
               {(0.740438615 + 0.747847739 + 0.738975804) / 3.0,
                (1.111274933 + 1.115626950 + 1.110355322) / 3.0});
  // pyBmodes, reference turbine 01_nrel5mw_land, 20 elements, without weight; as published, and
  // run with 200 elements for this test.
  check_within(0.02, found, {0.7343, 1.1083});
  check_within(2e-3, found, {0.74339, 1.11918});
  check_within(2e-3, find_pair(read_light_rotor(), 0.0), {0.69269, 1.11064});
}

TEST_CASE("the NREL 5 MW blade has converged in the number of elements") {
  for (const double speed : {0.0, kRated}) {
    const Pair fine = find_pair(read_rotor(8, 8), speed);
    check_within(3e-4, find_pair(read_rotor(4, 4), speed), fine);
    check_within(3e-4, find_pair(read_rotor(2, 8), speed), fine);
  }
}

}  // namespace spoke
