// Tests the warnings of a simulation: of bodies bent beyond the linear range, and of energy from
// nowhere.

#include "engine/simulation/observations.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/bodies/kernels/deformation_limits.h"
#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "models/error.h"
#include "tests/approx.h"
#include "tests/contains.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

/// A rotor of two blades at rest, the second bent by a slowly rising force at its tip.
Scenario bending_scenario(double force) {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(2, 3), 2);
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  PointLoad load;
  load.blade = BladeChoice::number(2);
  load.position = 8.0;
  load.force = {0.0, force};
  load.factor = Curve({0.0, 4.0}, {0.0, 1.0});
  scenario.rotor.loads.push_back(load);
  scenario.integration.step = 0.005;
  scenario.integration.duration = 5.0;
  return scenario;
}

/// All that a run shows about warnings.
struct Shown {
  std::uint64_t hash = 0;
  std::int64_t steps = 0;
  std::vector<double> warned_at;
  std::vector<std::string> texts;
  std::string divergence;
  int told = 0;  ///< steps that the observer was told of
  friend bool operator==(const Shown&, const Shown&) = default;
};

Shown run(const Scenario& scenario, const SimulationOptions& options, bool observed = true) {
  Simulation simulation(scenario, options);
  Shown shown;
  StepObserver observe = [&](double, std::span<const double>) { ++shown.told; };
  try {
    simulation.run_until(scenario.integration.duration, observed ? observe : StepObserver{});
  } catch (const DivergenceError& error) {
    shown.divergence = error.what();
  }
  for (const Warning& warning : simulation.warnings()) {
    shown.warned_at.push_back(warning.time);
    shown.texts.push_back(warning.text);
  }
  shown.hash = simulation.state_hash();
  shown.steps = simulation.steps();
  return shown;
}

/// Runs a scenario in all ways to make steps, and checks that they show the same, which it returns.
Shown run_all_ways(const Scenario& scenario) {
  const Shown single = run(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  for (const int window : {1, 7, 150}) {
    CAPTURE(window);
    CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::serial, 1, window}));
    CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window}));
  }
  return single;
}

/// Makes a scenario with rk4 a little beyond its stability limit: the fastest vibration grows
/// slowly.
Scenario growing_scenario() {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(2, 3), 2);
  scenario.rotor.hub.drive = SpinUp{4.0, 0.5};
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.duration = 1.0;
  scenario.integration.step = 1e-5;
  const Simulation probe(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  scenario.integration.step = 1.02 * probe.linear_properties().rk4_largest_step;
  return scenario;
}

}  // namespace

TEST_CASE("the deflection of a body is found at nodes and between them") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 3}) {
      CAPTURE(elements);
      Blade blade = wu_haug_blade(1, elements);
      blade.reference_frame = frame;
      SystemContext<Plane> context;
      context.linear_range = 0.1;
      make_context(make_rotor(blade, 1), Formulation::structured, Rk4{1e-4}, context);
      BodyData<Plane>& body = context.data.subsystems[0].bodies[0];
      const plane::FlexibleBody& model = *body.model->body;
      // An arc of curvature k: v = k x^2 / 2 on the tangent, k x (x - L) / 2 on the chord.
      const auto bend = [&](double k) {
        for (int node = 0; node <= elements; ++node) {
          const double x = 8.0 * node / elements;
          const double v = frame == ReferenceFrame::clamped ? k * x * x / 2 : k * x * (x - 8.0) / 2;
          const double psi = frame == ReferenceFrame::clamped ? k * x : k * (x - 4.0);
          if (const int at = model.coordinate(node, 1); at >= 0)
            body.coordinates.q[body.layout.offset(at)] = v;
          if (const int at = model.coordinate(node, kRotation); at >= 0)
            body.coordinates.q[body.layout.offset(at)] = psi;
        }
        return find_large_deflection(body);
      };
      // At the tip k L^2 / 2 = 32 k, in the middle of the chord (or near it) k L^2 / 8 = 8 k.
      const double largest = frame == ReferenceFrame::clamped ? 32.0 : 8.0;
      CHECK(bend(0.99 * 0.8 / largest) == 0.0);
      CHECK(bend(1.01 * 0.8 / largest) == approx(0.101));
      CHECK(bend(-0.3 * 8.0 / largest) == approx(0.3));
    }
}

TEST_CASE("no deflection beyond the range escapes the comparison of squares") {
  for (const double length : {2.0, 8.0, 80.0}) {
    Blade blade = wu_haug_blade(1, 1);
    blade.length = length;
    blade.reference_frame = ReferenceFrame::chord;
    SystemContext<Plane> context;
    context.linear_range = 0.1;
    make_context(make_rotor(blade, 1), Formulation::structured, Rk4{1e-4}, context);
    BodyData<Plane>& body = context.data.subsystems[0].bodies[0];
    const plane::FlexibleBody& model = *body.model->body;
    // Least squares for a deflection l / 8 (psi_0 - psi_1) just beyond the range.
    const double psi = 0.401;
    body.coordinates.q[body.layout.offset(model.coordinate(0, kRotation))] = psi;
    body.coordinates.q[body.layout.offset(model.coordinate(1, kRotation))] = -psi;
    CHECK(find_large_deflection(body) > 0.1);
    CHECK(2.0 * psi * psi > body.surely_linear);
  }
}

TEST_CASE("a body bent beyond the linear range is warned of once, on every executor and window") {
  const Shown shown = run_all_ways(bending_scenario(6.0));
  REQUIRE(shown.texts.size() == 1);
  CHECK(shown.divergence.empty());
  const std::string& text = shown.texts[0];
  CAPTURE(text);
  CHECK(text.find("blade 2 / body 1 bends by ") == 0);
  CHECK(contains(text, "more than 10 % of its length of 4 m"));
  CHECK(contains(text, "bodies instead of 2"));
  CHECK(shown.warned_at[0] > 0.5);
  CHECK(shown.warned_at[0] < 5.0);
  CHECK(run(bending_scenario(6.0), {Formulation::augmented, ExecutorKind::flow_graph, 2, 5})
            .texts.size() == 1);
}

TEST_CASE("the limit of deflections is set by the scenario, and 0 switches it off") {
  Scenario scenario = bending_scenario(6.0);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1, 1};
  const Shown usual = run(scenario, options);
  scenario.limits.deflection = 0.02;
  const Shown strict = run(scenario, options);
  REQUIRE(strict.texts.size() == 1);
  CHECK(strict.warned_at[0] < usual.warned_at[0]);
  CHECK(contains(strict.texts[0], "more than 2 % of"));
  scenario.limits.deflection = 0.0;
  CHECK(run(scenario, options).texts.empty());
  CHECK(strict.hash == usual.hash);
  CHECK(run(bending_scenario(0.1), options).texts.empty());
}

TEST_CASE("as many bodies as the warning suggests bend within the range") {
  Scenario scenario = bending_scenario(6.0);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1, 1};
  const Shown shown = run(scenario, options);
  REQUIRE(shown.texts.size() == 1);
  const std::string& text = shown.texts[0];
  CAPTURE(text);
  const std::string before = "into about ";
  REQUIRE(contains(text, before));
  const int bodies = std::stoi(text.substr(text.find(before) + before.size()));
  CHECK(bodies > 2);
  CHECK(bodies < 12);
  for (Blade& blade : scenario.rotor.blades) blade.bodies = bodies;
  CHECK(run(scenario, options).texts.empty());
}

TEST_CASE("warnings belong to the state: restore() sets them back, and a copy goes on with them") {
  const Scenario scenario = bending_scenario(6.0);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1, 1};
  Simulation simulation(scenario, options);
  const SavedState start = simulation.save();
  simulation.run_until(4.5);
  const SavedState middle = simulation.save();
  simulation.run_until(5.0);
  const auto warned = simulation.warnings();
  REQUIRE(warned.size() == 1);
  CHECK(warned[0].kind == WarningKind::linear_range);
  Simulation other(scenario, options);
  other.restore(middle);
  REQUIRE(other.warnings().size() == 1);
  other.run_until(5.0);
  CHECK(other.warnings()[0].text == warned[0].text);
  simulation.restore(start);
  CHECK(simulation.warnings().empty());
}

TEST_CASE("a saved state whose observations name no body of the model is refused") {
  const Scenario scenario = bending_scenario(6.0);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  simulation.run_until(4.5);
  REQUIRE(simulation.warnings().size() == 1);
  const SavedState saved = simulation.save();
  const std::size_t first = saved.values.size() - sizeof(Observations) / sizeof(double);
  for (const double blade : {2.0, -1.0, 0.5, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    SavedState bad = saved;
    bad.values[first + 2] = blade;  // after step and ratio
    CHECK_THROWS_AS(simulation.restore(bad), InputError);
  }
  simulation.restore(saved);
}

TEST_CASE("growth of the energy is judged by what is explained, and its change within a step") {
  constexpr GrowthLimit kPercent{0.01, 0.0};
  Observations seen;
  observe_start(100.0, seen);
  CHECK_FALSE(observe_energy(1, {100.9, 0.9}, kPercent, seen));
  CHECK_FALSE(observe_energy(2, {50.0, -50.0}, kPercent, seen));  // numerical damping
  CHECK_FALSE(observe_energy(3, {106.9, 3.9}, kPercent, seen));   // 3 more are explained
  CHECK_FALSE(observe_energy(4, {153.0, 50.0}, {}, seen));
  CHECK_FALSE(observe_energy(8, {121.0, 31.0}, kPercent, seen));
  CHECK_FALSE(observe_energy(8, {121.1, 31.1}, {0.01, 0.1}, seen));
  CHECK(observe_energy(9, {121.1, 31.1}, kPercent, seen));
  CHECK_FALSE(observe_energy(10, {122.0, 32.0}, kPercent, seen));  // once
  CHECK(seen.growth.step == 9.0);
  CHECK(seen.growth.energy == 103.0);
  CHECK(seen.growth.largest_residual == 32.0);
}

TEST_CASE("sound simulations grow no energy, from rest, under gravity and from a running start") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.005);
  scenario.integration.duration = 2.0;
  SUBCASE("driven") {}
  SUBCASE("large steps") { scenario.integration.step = 0.05; }
  SUBCASE("gravity") { scenario.rotor.gravity = Position{0.0, -9.81}; }
  SUBCASE("torque") { scenario.rotor.hub.drive = TorqueDrive{Curve(5.0), 0.0}; }
  SUBCASE("free") { scenario.rotor.hub.drive = FreeDrive{2.0}; }
  scenario.limits.on_energy_growth = EnergyGrowth::stop;
  const Shown shown = run(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  CHECK(shown.divergence.empty());
  for (const std::string& text : shown.texts) CHECK_FALSE(contains(text, "energy"));
}

TEST_CASE("growing energy is warned of, or stops the run in the step it appears in") {
  Scenario scenario = growing_scenario();
  const Shown warned = run_all_ways(scenario);
  REQUIRE(!warned.texts.empty());
  const std::string& text = warned.texts.back();
  CAPTURE(text);
  CHECK(contains(text, "the energy has grown by "));
  scenario.limits.on_energy_growth = EnergyGrowth::stop;
  const Shown stopped = run_all_ways(scenario);
  CAPTURE(stopped.divergence);
  CHECK(contains(stopped.divergence, "the energy has grown by "));
  CHECK(stopped.texts.empty());
  CHECK(contains(stopped.divergence, "above the stability limit of rk4"));
  CHECK(stopped.steps < warned.steps);
  CHECK(stopped.told == stopped.steps);
  const double step = scenario.integration.duration /
                      std::ceil(scenario.integration.duration / scenario.integration.step);
  CHECK(static_cast<double>(stopped.steps) * step == approx(warned.warned_at.back()));
  // The warning needs no observer, and comes step by step, too.
  const SimulationOptions options{Formulation::structured, ExecutorKind::flow_graph, 2, 20};
  const Shown unseen = run(scenario, options, false);
  CHECK(unseen.divergence == stopped.divergence);
  CHECK(unseen.hash == stopped.hash);
  Simulation simulation(scenario, options);
  CHECK_THROWS_AS(
      [&] {
        while (!simulation.done()) simulation.step();
      }(),
      DivergenceError);
  CHECK(simulation.state_hash() == stopped.hash);
  Simulation timed(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  CHECK_THROWS_WITH_AS(measure_nodes(timed, timed.planned_steps()), stopped.divergence.c_str(),
                       DivergenceError);
}

TEST_CASE("energy that comes from nowhere does not raise its own limit") {
  Observations seen;
  observe_start(1.0, seen);
  CHECK_FALSE(observe_energy(1.0, {1.1, 0.0}, {0.01, 0.0}, seen));
  // The energy grows at once, and to much more than there was.
  CHECK(observe_energy(2.0, {1e6, 1e6 - 1.2}, {0.01, 0.0}, seen));
  CHECK(seen.growth.energy == approx(1.2));
}

TEST_CASE("what the energy changes by in a step in which the drive jumps excuses no growth") {
  for (const bool has_jump : {false, true}) {
    Observations seen;
    observe_start(0.0, seen);
    CHECK_FALSE(observe_energy(1.0, {8.0, 0.0}, {0.01, 0.0, has_jump}, seen));
    CHECK(observe_energy(2.0, {8.5, 0.5}, {0.01, 0.0}, seen) == has_jump);
  }
}

TEST_CASE("energy that grows in space warns or stops, and rk4's limit is named as its cause") {
  Scenario scenario = parse_scenario(R"(
world = "space"
[hub.drive]
kind = "constant"
speed = 30.0
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
method = "rk4"
step = 0.005
duration = 0.4
)",
                                     "unstable.toml");
  const SimulationOptions serial{Formulation::structured, ExecutorKind::serial, 1, 1};
  const Shown warned = run(scenario, serial);
  REQUIRE(warned.texts.size() == 1);
  CHECK(contains(warned.texts[0], "the energy has grown by "));
  CHECK(warned.texts[0].ends_with(": take a smaller integration.step"));
  scenario.limits.on_energy_growth = EnergyGrowth::stop;
  const Shown stopped = run(scenario, serial);
  CHECK(contains(stopped.divergence, "the energy has grown by "));
  CHECK(
      contains(stopped.divergence, "; the step of 0.005 s is above the stability limit of rk4, "));
  CHECK(stopped.divergence.ends_with(": take a smaller integration.step, or generalized_alpha"));
  CHECK(stopped.steps < warned.steps);
}
