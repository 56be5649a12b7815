// Windows of steps: blades under a prescribed hub run ahead of one another, and nothing shows it.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "models/error.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// On a prescribed hub, and long enough for `auto` to choose a window.
Scenario unequal_scenario(IntegrationMethod method) {
  Scenario scenario = test::unequal_scenario(HubSupport::axle, method);
  scenario.integration.duration = method == IntegrationMethod::rk4 ? 0.02 : 3.0;
  return scenario;
}

/// Everything that a run shows.
struct Shown {
  std::uint64_t hash = 0;
  std::int64_t steps = 0;
  std::int64_t evaluations = 0;
  std::vector<double> rows;
  std::string divergence;
  friend bool operator==(const Shown&, const Shown&) = default;
};

Shown run(const Scenario& scenario, const SimulationOptions& options, bool observed = true) {
  Simulation simulation(scenario, options);
  Shown shown;
  StepObserver observe = [&](double t, std::span<const double> sensors) {
    shown.rows.push_back(t);
    shown.rows.insert(shown.rows.end(), sensors.begin(), sensors.end());
  };
  try {
    // In parts, so that windows end early, and with a single step in between.
    simulation.run_until(0.3 * scenario.integration.duration, observed ? observe : StepObserver{});
    simulation.step();
    simulation.run_until(scenario.integration.duration, observed ? observe : StepObserver{});
  } catch (const DivergenceError& error) {
    shown.divergence = error.what();
  }
  shown.hash = simulation.state_hash();
  shown.steps = simulation.steps();
  shown.evaluations = simulation.evaluations();
  const auto last = simulation.sensor_values();
  shown.rows.insert(shown.rows.end(), last.begin(), last.end());
  return shown;
}

}  // namespace

TEST_CASE("a window of any width shows the same as steps one by one") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
    for (const Formulation formulation : {Formulation::structured, Formulation::subsystem}) {
      const Scenario scenario = unequal_scenario(method);
      const Shown single = run(scenario, {formulation, ExecutorKind::serial, 1, 1});
      CHECK(single.divergence.empty());
      CHECK(single.steps == std::lround(scenario.integration.duration / scenario.integration.step));
      for (const int window : {2, 5, 20, 200}) {
        CAPTURE(window);
        CHECK(single == run(scenario, {formulation, ExecutorKind::serial, 1, window}));
        CHECK(single == run(scenario, {formulation, ExecutorKind::flow_graph, 3, window}));
      }
    }
}

TEST_CASE("steps that nobody observes are the same steps") {
  const Scenario scenario = unequal_scenario(IntegrationMethod::generalized_alpha);
  const SimulationOptions options{Formulation::structured, ExecutorKind::flow_graph, 2, 20};
  const Shown observed = run(scenario, options), unseen = run(scenario, options, false);
  CHECK(observed.hash == unseen.hash);
  CHECK(observed.evaluations == unseen.evaluations);
}

TEST_CASE("a window around a system that meets at the hub is step after step") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    Scenario scenario = unequal_scenario(IntegrationMethod::generalized_alpha);
    scenario.rotor.hub.support = support;
    scenario.rotor.hub.mass = 10.0;
    scenario.rotor.hub.drive = TorqueDrive{Curve(30.0), 0.5};
    const Shown single = run(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
    CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::serial, 1, 20}));
    CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, 7}));
  }
}

TEST_CASE("a failure within a window is found, told and left as step by step") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 4), 0.005);
  scenario.rotor.blades[1].geometric_stiffening = false;  // fails beyond 3 rad/s
  scenario.integration.duration = 12.0;
  const Shown single = run(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  CHECK(single.divergence.find("blade 2 / body 1: deflection v") != std::string::npos);
  for (const int window : {3, 20, 150}) {
    CAPTURE(window);
    CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::serial, 1, window}));
    CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window}));
  }
}

TEST_CASE("an iteration that does not converge within a window is found as step by step") {
  Scenario scenario = unequal_scenario(IntegrationMethod::generalized_alpha);
  scenario.integration.tolerance = 1e-13;
  scenario.integration.max_iterations = 2;
  const Shown single = run(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
  CHECK(single.divergence.find("the iteration still changes a coordinate") != std::string::npos);
  CHECK(single == run(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, 10}));
}

TEST_CASE("what an observer throws comes back, and no executor is left behind") {
  const Scenario scenario = unequal_scenario(IntegrationMethod::generalized_alpha);
  for (const int window : {1, 20}) {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window});
    int calls = 0;
    const StepObserver observe = [&calls](double, std::span<const double>) {
      if (++calls == 30) throw std::runtime_error("enough");
    };
    CHECK_THROWS_WITH(simulation.run_until(2.0, observe), "enough");
    CHECK(calls == 30);
  }
}

TEST_CASE("auto's window is opened without planning, and the steps in it are the same") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.005);
  scenario.integration.duration = 10.0;
  scenario.limits.on_energy_growth = EnergyGrowth::stop;  // looks at every step
  Simulation simulation(scenario, {.executor = ExecutorKind::automatic, .threads = 2});
  const int steps = open_window(simulation);
  CHECK(steps > 1);
  CHECK(steps == open_window(simulation));  // is open already
  CHECK(simulation.executor_description().starts_with("windows of " + std::to_string(steps)));
  const int nodes = simulation.run_graph().node_count();
  CHECK(nodes > 2 * simulation.step_graph().node_count());
  const NodeMeasurement measured = measure_nodes(simulation, 8 * steps);
  CHECK(measured.costs.size() == static_cast<std::size_t>(nodes));
  CHECK(measured.runs_per_step < 1.0);
  Simulation serial(scenario, {.executor = ExecutorKind::serial, .threads = 1});
  serial.run_until(simulation.time());
  CHECK(serial.steps() == simulation.steps());
  CHECK(serial.state_hash() == simulation.state_hash());
}

TEST_CASE("a window of 1 is a graph of one pass, also where steps take many") {
  Scenario scenario = unequal_scenario(IntegrationMethod::generalized_alpha);
  scenario.integration.tolerance = 1e-12;
  scenario.integration.duration = 10.0;
  Simulation simulation(scenario, {.executor = ExecutorKind::automatic, .threads = 2, .window = 1});
  CHECK(open_window(simulation) == 1);
  CHECK(simulation.evaluations() >= 4 * simulation.steps());
  CHECK(&simulation.run_graph() != &simulation.step_graph());
  CHECK(simulation.run_graph().node_count() == simulation.step_graph().node_count());
}

TEST_CASE("where no step is left there is no window to open") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.005);
  scenario.integration.duration = 0.02;
  for (const double time : {0.0, 0.02}) {
    Simulation simulation(scenario, {.executor = ExecutorKind::automatic, .threads = 2});
    simulation.run_until(time);
    CHECK(open_window(simulation) == 1);
    CHECK(simulation.steps() == simulation.planned_steps());
    CHECK(&simulation.run_graph() == &simulation.step_graph());
  }
}

TEST_CASE("who chooses no window opens none") {
  const Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.005);
  for (const SimulationOptions& options :
       {SimulationOptions{.executor = ExecutorKind::automatic, .threads = 1},
        SimulationOptions{.executor = ExecutorKind::flow_graph, .threads = 2}}) {
    Simulation simulation(scenario, options);
    CHECK(open_window(simulation) == 1);
    CHECK(simulation.steps() == 0);
    CHECK(&simulation.run_graph() == &simulation.step_graph());
  }
  Simulation asked(scenario, {.executor = ExecutorKind::serial, .threads = 1, .window = 5});
  CHECK(open_window(asked) == 5);
}
