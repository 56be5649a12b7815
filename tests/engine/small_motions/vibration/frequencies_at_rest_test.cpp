// Tests the ends of the spectrum of models in space at rest, and the steps that rk4 can make.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/small_motions/vibration/frequency_limits.h"
#include "models/error.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

using vibration::find_frequency_limits;
using vibration::FrequencyLimits;

/// Returns the highest frequency of all modes at rest.
double find_highest(const Scenario& scenario, int modes) {
  const ModesResult result = solve_modes(scenario, {.state = {.speed = 0.0}, .count = modes});
  double highest = 0.0;
  for (const Mode& mode : result.modes) highest = std::max(highest, std::abs(mode.eigenvalue));
  return highest;
}

/// Whether a blade that is knocked at its tip stays bounded over so many steps of rk4.
bool is_stable(Scenario scenario, double step) {
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.step = step;
  scenario.integration.duration = 1500 * step;
  scenario.limits.deflection = 0.0;
  scenario.limits.energy_growth = 0.0;
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, 0});
  try {
    simulation.run_until(scenario.integration.duration);
  } catch (const DivergenceError&) {
    return false;
  }
  return std::abs(simulation.sensor("blade1.tip.z")) < 1e-3;
}

const std::string kKnock = "[[load]]\nforce = [1e-5, 1e-5, 1e-5]\n";

}  // namespace

TEST_CASE("rest: the ends are those of all modes of a clamped blade") {
  const Scenario blade = test::make_spatial({.bodies = 2, .elements = 3});
  const FrequencyLimits found = find_frequency_limits(blade);
  CHECK(found.lowest == doctest::Approx(3.51601527).epsilon(1e-4));
  CHECK(found.highest == doctest::Approx(find_highest(blade, 36)).epsilon(1e-8));
  CHECK(found.rk4.step == doctest::Approx(2.0 * std::sqrt(2.0) / found.highest));
}

TEST_CASE("rest: rigid motions do not count, those of a free hub and of loose hinges") {
  const Scenario booms = test::read_shipped("satellite_booms");
  const FrequencyLimits found = find_frequency_limits(booms);
  const ModesResult modes = solve_modes(booms, {.state = {.speed = 0.0}, .count = 8});
  CHECK(modes.modes.at(5).eigenvalue == 0.0);
  CHECK(found.lowest == doctest::Approx(std::abs(modes.modes.at(6).eigenvalue)).epsilon(1e-3));
  CHECK(found.highest > 100.0 * found.lowest);
  const Scenario hinged = test::make_spatial(
      {.bodies = 1,
       .joint = "[[blades.joint]]\nname = \"hinge\"\nstation = 0.0\nkind = \"revolute\"\n"
                "axis = [0.0, -1.0, 0.0]\n"});
  CHECK(find_frequency_limits(hinged).lowest == doctest::Approx(3.51601527).epsilon(1e-3));
}

TEST_CASE("rest: a planar rotor in space has the lowest frequency of the plane") {
  const double plane =
      Simulation(test::read_shipped("wu_haug_rotor")).linear_properties().lowest_frequency;
  Scenario space = test::read_shipped("spatial_wu_haug");
  for (spatial::Blade& blade : space.space->blades)
    blade.beam.sections.flap_stiffness = blade.beam.sections.lag_stiffness;
  CHECK(Simulation(space).linear_properties().lowest_frequency ==
        doctest::Approx(plane).epsilon(1e-6));
}

TEST_CASE("rest: a top does not vibrate") {
  const LinearProperties properties =
      Simulation(test::read_shipped("heavy_top")).linear_properties();
  CHECK(properties.lowest_frequency == 0.0);
  CHECK(properties.highest_frequency == 0.0);
  CHECK(std::isinf(properties.rk4_largest_step));
}

TEST_CASE("rest: rk4 is stable up to the step that is told, and not far beyond") {
  const std::string damped = "[damping]\nstiffness_factor = 1e-3\nmass_factor = 0.5\n";
  for (const std::string& more : {kKnock, kKnock + damped}) {
    CAPTURE(more);
    const Scenario blade =
        test::make_spatial({.bodies = 1, .elements = 2, .axial_stiffness = 1e4, .more = more});
    const double step = find_frequency_limits(blade).rk4.step;
    CHECK(is_stable(blade, 0.99 * step));
    CHECK_FALSE(is_stable(blade, 1.02 * step));
  }
}

TEST_CASE("rest: a strong damper of a hinge shortens rk4's step") {
  const auto blade = [](const std::string& damping) {
    return test::make_spatial(
        {.bodies = 1,
         .elements = 1,
         .axial_stiffness = 1e3,
         .joint = "[[blades.joint]]\nname = \"hinge\"\nstation = 0.0\nkind = \"revolute\"\n"
                  "axis = [0.0, -1.0, 0.0]\nstiffness = 1.0\ndamping = " +
                  damping + '\n',
         .more = kKnock});
  };
  const double strong = find_frequency_limits(blade("200.0")).rk4.step;
  CHECK(strong < 0.5 * find_frequency_limits(blade("0.0")).rk4.step);
  CHECK(is_stable(blade("200.0"), 0.99 * strong));
  CHECK_FALSE(is_stable(blade("200.0"), 2.0 * strong));
}

}  // namespace spoke
