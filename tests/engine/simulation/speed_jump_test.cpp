// Tests warnings of a drive that jumps, and of the energy that it makes.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/simulation/observations.h"
#include "models/error.h"
#include "tests/contains.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Messages of a run.
struct Told {
  std::vector<std::string> warnings;
  std::string divergence;
};
Told run(const Scenario& scenario) {
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  Told told;
  try {
    simulation.run_until(scenario.integration.duration, [](double, std::span<const double>) {});
  } catch (const DivergenceError& error) {
    told.divergence = error.what();
  }
  for (const Warning& warning : simulation.warnings()) told.warnings.push_back(warning.text);
  return told;
}

}  // namespace

TEST_CASE("where a drive that jumps makes energy, smaller steps are not the advice") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 2), 0.005);
  scenario.rotor.hub.drive = SpeedTable{Curve({0.0, 0.1, 0.1 + 1e-9}, {0.0, 0.0, 4.0})};
  scenario.integration.duration = 0.2;
  const std::string advice =
      "the drive's speed jumps at t = 0.1 s, let the change take 0.02 s or more";
  const Told warned = run(scenario);
  REQUIRE(warned.warnings.size() == 2);
  CHECK(contains(warned.warnings[0], "the energy has grown by "));
  CHECK(warned.warnings[0].ends_with(advice));
  CHECK(warned.warnings[1].ends_with("; let the change take 0.02 s or more"));
  scenario.limits.on_energy_growth = EnergyGrowth::stop;
  const Told stopped = run(scenario);
  CHECK(stopped.divergence.ends_with(advice));
  // This growth has nothing to do with the jump.
  Observations seen;
  for (const double step : {10.0, 100.0}) {
    seen.growth.step = step;
    CHECK(advise_on_growth(scenario, 0.005, seen) == "take a smaller integration.step");
  }
}

TEST_CASE("light blades on a hub that starts smoothly are warned of nothing") {
  // In the first step the quadrature sees hardly anything of the work on the blades.
  Blade blade = wu_haug_blade(2, 3);
  blade.length = 4.0;
  blade.density = 1350.0;
  Scenario scenario = spin_up_scenario(blade, 0.005);
  scenario.rotor.hub.drive = SpinUp{4.0, 0.5};
  scenario.rotor.hub.inertia = 1.0;
  scenario.integration.duration = 0.25;
  CHECK(run(scenario).warnings.empty());
}

TEST_CASE("a drive in space that jumps is warned of") {
  Scenario scenario = parse_scenario(R"(
world = "space"
[hub.drive]
kind = "table"
time = [0.0, 0.1, 0.100000001]
speed = [0.0, 0.0, 4.0]
[blade]
count = 1
length = 2.0
bodies = 1
elements = 2
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e5
flap_stiffness = 50.0
lag_stiffness = 50.0
torsion_stiffness = 50.0
[integration]
duration = 0.2
)",
                                     "jump.toml");
  const Told warned = run(scenario);
  REQUIRE(warned.warnings.size() == 2);
  // The energy that the hub takes, 8 J at once, excuses no growth.
  CHECK(contains(warned.warnings[0], "the energy has grown by "));
  CHECK(warned.warnings[0].ends_with("let the change take 0.02 s or more"));
  CHECK(contains(warned.warnings[1],
                 "at t = 0.1 s the drive changes the speed by 4 rad/s within 1e-09 s"));
  CHECK(warned.warnings[1].ends_with("let the change take 0.02 s or more"));
  scenario.limits.on_energy_growth = EnergyGrowth::stop;
  const Told stopped = run(scenario);
  CHECK(stopped.divergence.ends_with("let the change take 0.02 s or more"));
}

TEST_CASE("a drive that changes the speed within less than four steps is warned of") {
  const auto warning_of = [](const Drive& drive) -> std::string {
    Scenario scenario;
    scenario.rotor = make_rotor(wu_haug_blade(1, 2), 1);
    scenario.rotor.hub.drive = drive;
    scenario.integration.step = 0.005;
    scenario.integration.duration = 4.0;
    const Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
    const std::vector<Warning> warnings = simulation.warnings();
    if (warnings.empty()) return {};
    CHECK(warnings.size() == 1);
    CHECK(warnings[0].kind == WarningKind::speed_jump);
    return warnings[0].text;
  };
  CHECK(contains(warning_of(SpinUp{4.0, 1e-9}),
                 "at t = 0 s the drive changes the speed by 4 rad/s within 1e-09 s"));
  CHECK(contains(warning_of(SpinUpHoldSpinDown{4.0, 1.0, 1.0, 0.01}),
                 "at t = 2 s the drive changes the speed by -4 rad/s within 0.01 s"));
  CHECK(contains(warning_of(SpeedTable{Curve({0.0, 1.0, 1.001}, {0.0, 0.0, 3.0})}),
                 "at t = 1 s the drive changes the speed by 3 rad/s within 0.001"));
  CHECK(warning_of(SpinUp{4.0, 0.02}).empty());
  // Smaller steps are advised where they are within reason.
  CHECK(warning_of(SpinUp{4.0, 1e-9}).ends_with("; let the change take 0.02 s or more"));
  CHECK(warning_of(SpinUp{4.0, 0.01})
            .ends_with("; let the change take 0.02 s or more, or take an integration.step of "
                       "0.0025 s or less"));
  CHECK(warning_of(SpinUp{0.0, 1e-9}).empty());
  CHECK(warning_of(SpinUpHoldSpinDown{4.0, 1.0, 5.0, 0.01}).empty());  // after the end
  CHECK(warning_of(SpeedTable{Curve({0.0, 1.0, 2.0}, {0.0, 0.0, 3.0})}).empty());
}
