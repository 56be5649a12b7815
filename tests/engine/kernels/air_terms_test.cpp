// Air in the steps of a simulation: laws of mechanics, one state for all ways to make a step, saved
// states.

#include "engine/kernels/air_terms.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "graph/execute/executor_kinds.h"
#include "tests/approx.h"
#include "tests/engine/space/system/models.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

const std::string kStall = "[aerodynamics]\nstall = \"dynamic\"\ninflow = \"dynamic\"\n";

Scenario make(const std::string& text, double step, double duration,
              IntegrationMethod method = IntegrationMethod::generalized_alpha) {
  Scenario scenario = parse_scenario(text, "rotor.toml");
  scenario.integration.step = step;
  scenario.integration.duration = duration;
  scenario.integration.method = method;
  return scenario;
}

/// Returns the value of a column in the last step.
double value_of(const Simulation& simulation, const std::string& name) {
  const std::vector<std::string>& names = simulation.sensor_names();
  const auto at = std::find(names.begin(), names.end(), name);
  REQUIRE(at != names.end());
  return simulation.sensor_values()[static_cast<std::size_t>(at - names.begin())];
}

std::uint64_t hash_after(const Scenario& scenario, const SimulationOptions& options) {
  Simulation simulation(scenario, options);
  simulation.run_until(scenario.integration.duration);
  return simulation.state_hash();
}

}  // namespace

TEST_CASE("a rotor in air has one state with every executor and window") {
  for (const std::string& hub : {kDrivenHub, kTurnedHub}) {
    const Scenario scenario = make(make_text(hub, kBooms + kAir, kStall), 1e-3, 0.1);
    for (const Formulation formulation : {Formulation::structured, Formulation::subsystem}) {
      const std::uint64_t expected =
          hash_after(scenario, {formulation, graph::ExecutorKind::serial, 1, 1});
      for (const graph::ExecutorKind kind :
           {graph::ExecutorKind::serial, graph::ExecutorKind::flow_graph,
            graph::ExecutorKind::openmp_tasks})
        for (const int window : {1, 7}) {
          CAPTURE(name_of(kind));
          CAPTURE(window);
          CHECK(hash_after(scenario, {formulation, kind, 3, window}) == expected);
        }
    }
  }
}

TEST_CASE("three formulations agree in air") {
  const Scenario scenario = make(make_text(kTurnedHub, kBooms + kAir, kStall), 1e-3, 0.2);
  std::vector<double> tips;
  for (const Formulation formulation :
       {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
    Simulation simulation(scenario, {formulation, graph::ExecutorKind::serial, 1, 1});
    simulation.run_until(0.2);
    tips.push_back(value_of(simulation, "blade1.tip.z"));
  }
  CHECK(std::abs(tips[0]) > 1e-4);
  CHECK(tips[1] == approx(tips[0]).epsilon(1e-8));
  CHECK(tips[2] == approx(tips[0]).epsilon(1e-8));
}

TEST_CASE("both integrators come to one motion in air with states of inflow and stall") {
  const std::string text = make_text(kDrivenHub, kBooms + kAir, kStall);
  const auto tip = [&](IntegrationMethod method, double step) {
    Simulation simulation(make(text, step, 0.5, method));
    simulation.run_until(0.5);
    return value_of(simulation, "blade1.tip.z");
  };
  const double exact = tip(IntegrationMethod::rk4, 1.25e-4);
  const double coarse = tip(IntegrationMethod::generalized_alpha, 4e-3) - exact;
  const double fine = tip(IntegrationMethod::generalized_alpha, 1e-3) - exact;
  CAPTURE(exact);
  CAPTURE(coarse);
  CHECK(std::abs(fine) < 1e-4 * std::abs(exact) + 1e-7);
  CHECK(std::abs(fine) < 0.2 * std::abs(coarse) + 1e-8);
}

TEST_CASE("a saved state in air goes on to the same bits") {
  for (const std::string& hub : {kDrivenHub, kTurnedHub}) {
    const Scenario scenario = make(make_text(hub, kBooms + kAir, kStall), 1e-3, 0.2);
    Simulation whole(scenario);
    whole.run_until(0.1);
    const SavedState saved = whole.save();
    whole.run_until(0.2);
    Simulation other(scenario);
    other.restore(saved);
    other.run_until(0.2);
    CHECK(other.state_hash() == whole.state_hash());
    CHECK(value_of(other, "air.thrust") == value_of(whole, "air.thrust"));
    whole.restore(saved);
    whole.run_until(0.2);
    CHECK(whole.state_hash() == other.state_hash());
  }
}

TEST_CASE("the drive does the work that air takes from a rotor, and the balance of energy closes") {
  Simulation simulation(make(make_text(kDrivenHub, kBooms + kAir, kStall), 5e-4, 1.0));
  simulation.run_until(1.0);
  const double stored =
      value_of(simulation, "energy.kinetic") + value_of(simulation, "energy.strain");
  CHECK(std::abs(value_of(simulation, "energy.residual")) < 1e-3 * stored);
}

TEST_CASE("a driven rotor in axial wind settles at its equilibrium, with the torque of air") {
  const std::string damping = "[damping]\nstiffness_factor = 0.02\n";
  std::string air = kAir;
  const std::string wind = "velocity = [0.5, 3.0, 1.0]";
  air.replace(air.find(wind), wind.size(), "velocity = [0.0, 3.0, 0.0]");
  const std::string constant =
      "\n[hub]\nmass = 10.0\ninertia = [2.0, 2.0, 3.0]\naxis = [0.0, 1.0, 0.0]\nradius = 0.3\n"
      "[hub.drive]\nkind = \"constant\"\nspeed = 12.0\n";
  const Scenario scenario =
      make(make_text(constant, kBooms + air, damping + "[initial]\nstate = \"equilibrium\"\n"),
           1e-3, 0.5);
  const EquilibriumResult equilibrium = solve_equilibrium(scenario);
  REQUIRE(equilibrium.air.has_value());
  CHECK(equilibrium.air->wind == approx(3.0));
  Simulation simulation(scenario);
  simulation.run_until(0.5);
  const Eigen::Vector3d& tip = equilibrium.blades[0].tip_displacement;
  CHECK(std::abs(tip.z()) > 1e-3);
  CHECK(value_of(simulation, "blade1.tip.z") == approx(tip.z()).epsilon(1e-6));
  CHECK(value_of(simulation, "air.thrust") == approx(equilibrium.air->thrust).epsilon(1e-6));
  // In steady rotation the drive holds what air does.
  CHECK(value_of(simulation, "hub.torque") ==
        approx(-value_of(simulation, "air.torque")).epsilon(1e-5));
}

TEST_CASE("without air the aerodynamics of blades change nothing") {
  std::string still = kAir;
  still.erase(still.find("[[airfoil]]"));
  const Scenario with = make(make_text(kDrivenHub, kBooms + still), 1e-3, 0.05);
  const Scenario without = make(make_text(kDrivenHub, kBooms), 1e-3, 0.05);
  const SimulationOptions options{Formulation::structured, graph::ExecutorKind::serial, 1, 1};
  CHECK(hash_after(with, options) == hash_after(without, options));
}
