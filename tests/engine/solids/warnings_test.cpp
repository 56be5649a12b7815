// Warnings of solids that deform beyond the range of linear elasticity.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/contains.h"
#include "tests/engine/solids/solid_models.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;
using spoke::testing::approx;

namespace {

/// A rubber bar of 1 x 0.1 x 0.1 m held at its root, with a force across its tip that bends it by
/// `share` of its length.
Scenario make_bent_bar(double share) {
  Scenario scenario;
  spatial::Model& model = scenario.space.emplace();
  model.hub.drive = FixedDrive{};
  spatial::Subsystem& subsystem = model.subsystems.emplace_back();
  subsystem.name = "holder";
  subsystem.bodies = {{"bar", make_bar(slender_grid(), rubber())}};
  subsystem.joints.emplace_back().child = "bar";
  spatial::PointLoad load;
  load.place.subsystem = "holder";
  load.place.body = "bar";
  load.interface = "tip";
  load.force = Vector(0.0, 0.0, share * 3.0 * 1e7 * 1e-4 / 12.0);  // 3 EI / L^2
  model.loads.push_back(load);
  scenario.integration.step = 1e-3;
  scenario.integration.duration = 0.2;
  return scenario;
}

}  // namespace

TEST_CASE("a solid that deforms beyond the limit is warned of in words of its own") {
  Scenario scenario = make_bent_bar(0.2);
  const EquilibriumResult bent = solve_equilibrium(scenario);
  // Its tip turns by 3/2 of its displacement by the length.
  REQUIRE(bent.blades[0].bending.size() == 1);
  CHECK(bent.blades[0].bending[0] == approx(0.3).epsilon(0.1));
  REQUIRE(bent.warnings.size() == 1);
  const std::string& at_rest = bent.warnings[0].text;
  CAPTURE(at_rest);
  CHECK(at_rest.starts_with("holder / bar deforms by "));
  CHECK(contains(at_rest, "10 times the largest strain), more than 10 %, up to which"));
  CHECK(contains(at_rest, "cut the solid into several"));

  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  simulation.run_until(0.2);
  std::vector<std::string> texts;
  for (const Warning& warning : simulation.warnings())
    if (warning.kind == WarningKind::linear_range) texts.push_back(warning.text);
  REQUIRE(texts.size() == 1);
  CAPTURE(texts[0]);
  CHECK(texts[0].starts_with("holder / bar deforms by "));
  CHECK(contains(texts[0], " at t = "));
  CHECK(contains(texts[0], "(holder / bar, t = "));

  scenario.limits.deflection = 0.4;
  CHECK(solve_equilibrium(scenario).warnings.empty());
  CHECK(solve_equilibrium(make_bent_bar(0.05)).warnings.empty());
}
