// Air in the steps of a simulation: laws of mechanics, one state for all ways to make a step, saved
// states.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/bodies/act/air/air_on_blades.h"
#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "graph/execute/executor_kinds.h"
#include "tests/approx.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

const std::string kStall = "[aerodynamics]\nstall = \"dynamic\"\ninflow = \"dynamic\"\n";
const std::string kQuasiSteady = "[aerodynamics]\nstall = \"static\"\ninflow = \"quasi_steady\"\n";

/// A rotor of two blades of 100 m with light tips, straight in a wind that begins at once: their
/// tips soon move as fast as the wind. There the wake makes the load of the last station, whose
/// loss factor is small, fifty times as steep as its lift curve is.
const std::string kTipsOvertakeWind = R"(
world = "space"
[hub]
axis = [1, 0, 0]
radius = 3
drive = { kind = "constant", speed = 0.5235987755982988 }
[blade]
count = 2
length = 99.9963
bodies = 1
elements = 4
[blade.sections]
station = [0, 8.2, 16.3, 24.1, 31, 38.8, 46.9, 55.1, 62.1, 69.4, 77.5, 85.7, 93.1, 99.9963]
mass_per_length = [2200, 1200, 680, 450, 410, 380, 320, 240, 170, 110, 73, 44, 23, 7.7]
axial_stiffness = [3.2e+10, 2e+10, 1.5e+10, 1.3e+10, 1.4e+10, 1.5e+10, 1.4e+10, 1.2e+10, 8.8e+09,
  5.9e+09, 3.7e+09, 2.1e+09, 8.9e+08, 4.1e+08]
flap_stiffness = [7.8e+10, 2.3e+10, 6.9e+09, 4.1e+09, 3.3e+09, 3.1e+09, 2.2e+09, 1.3e+09, 6.8e+08,
  3.1e+08, 1.1e+08, 3e+07, 5.1e+06, 600000]
lag_stiffness = [7.8e+10, 3.7e+10, 1.9e+10, 1.3e+10, 1.2e+10, 1e+10, 7e+09, 4.3e+09, 2.3e+09,
  1.1e+09, 4.5e+08, 1.4e+08, 2.9e+07, 3.9e+06]
torsion_stiffness = [4.6e+10, 1.2e+10, 2.4e+09, 7.9e+08, 4.7e+08, 3.5e+08, 2.1e+08, 1e+08,
  5.1e+07, 2.4e+07, 1e+07, 3.4e+06, 710000, 53000]
[blade.aerodynamics]
station = [86.2, 89.7, 93.1, 96.6, 99.9963]
chord = [1.39, 1.17, 0.944, 0.722, 0.5]
center = [0.129, 0.109, 0.0909, 0.0734, 0.0565]
twist = 0
airfoil = "tip"
[air]
[aerodynamics]
inflow = "quasi_steady"
stall = "static"
[[airfoil]]
name = "tip"
angle = [-3.141592653589793, -2.35619, -1.5708, -0.7854, -0.16396, -0.12164, -0.07933, -0.03702,
  0.00529, 0.0476, 0.08991, 0.13222, 0.17453, 0.21684, 0.25915, 0.30147, 0.34378, 0.7854, 1.5708,
  2.35619, 3.141592653589793]
lift = [0, 0.8022, -0, -0.8022, -0.3878, -0.1815, 0.0248, 0.3065, 0.6036, 0.8919, 1.1616, 1.3914,
  1.6237, 1.8061, 1.906, 1.8678, 1.7972, 1.146, 0, -0.8022, 0]
drag = [0.001, 0.6795, 1.5, 0.6795, 0.0317, 0.0203, 0.0088, 0.0056, 0.0057, 0.0064, 0.0083,
  0.0123, 0.0155, 0.0212, 0.0308, 0.0515, 0.0786, 0.6795, 1.5, 0.6795, 0.001]
[wind]
velocity = [7.92, 0, 1.11]
[integration]
duration = 0.3
)";

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
  const std::vector<std::string> texts{make_text(kDrivenHub, kBooms + kAir, kStall),
                                       make_text(kTurnedHub, kBooms + kAir, kStall),
                                       make_text(kTurnedHub, kBooms + kAir, kQuasiSteady)};
  for (const std::string& text : texts) {
    const Scenario scenario = make(text, 1e-3, 0.1);
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
  for (const std::string& lags : {kStall, kQuasiSteady}) {
    const Scenario scenario = make(make_text(kTurnedHub, kBooms + kAir, lags), 1e-3, 0.2);
    std::vector<double> tips;
    for (const Formulation formulation :
         {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
      Simulation simulation(scenario, {formulation, graph::ExecutorKind::serial, 1, 1});
      simulation.run_until(0.2);
      tips.push_back(value_of(simulation, "blade2.tip.z"));
    }
    CHECK(std::abs(tips[0]) > 1e-4);
    CHECK(tips[1] == approx(tips[0]).epsilon(1e-8));
    CHECK(tips[2] == approx(tips[0]).epsilon(1e-8));
  }
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

TEST_CASE("with quasi-steady inflow both integrators come to one motion, by second order") {
  const std::string text = make_text(kTurnedHub, kBooms + kAir, kQuasiSteady);
  const auto tip = [&](IntegrationMethod method, double step) {
    Simulation simulation(make(text, step, 0.5, method));
    simulation.run_until(0.5);
    return value_of(simulation, "blade2.tip.z");
  };
  // rk4 solves the annuli at the motion of each stage, the other at the motion that it predicts.
  const double exact = tip(IntegrationMethod::rk4, 1.25e-4);
  const double coarse = tip(IntegrationMethod::generalized_alpha, 4e-3) - exact;
  const double fine = tip(IntegrationMethod::generalized_alpha, 5e-4) - exact;
  CAPTURE(exact);
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK(std::abs(fine) < 2e-5 * std::abs(exact));
  CHECK(std::abs(fine) < std::abs(coarse) / 30.0);  // second order: 64
}

TEST_CASE("blades whose tips overtake the wind go on with quasi-steady inflow at any step") {
  const auto tips = [&](IntegrationMethod method, double step) {
    Simulation simulation(make(kTipsOvertakeWind, step, 0.3, method));
    simulation.run_until(0.3);
    return std::vector<double>{value_of(simulation, "blade1.tip.z"),
                               value_of(simulation, "blade2.tip.z")};
  };
  const std::vector<double> exact = tips(IntegrationMethod::rk4, 5e-4);
  REQUIRE(exact[0] > 1.0);
  for (const double step : {0.01, 0.006, 0.004, 0.002}) {
    CAPTURE(step);
    const std::vector<double> found = tips(IntegrationMethod::generalized_alpha, step);
    for (std::size_t k = 0; k < 2; ++k)
      CHECK(found[k] == approx(exact[k]).epsilon(30.0 * step * step + 5e-4));
  }
}

TEST_CASE("a saved state in air goes on to the same bits") {
  const std::vector<std::string> texts{make_text(kDrivenHub, kBooms + kAir, kStall),
                                       make_text(kTurnedHub, kBooms + kAir, kStall),
                                       make_text(kDrivenHub, kBooms + kAir, kQuasiSteady)};
  for (const std::string& text : texts) {
    const Scenario scenario = make(text, 1e-3, 0.2);
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
