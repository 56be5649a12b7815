// Laws of runs, for every model of the zoo: one state whatever makes the steps, formulations that
// agree, states that are saved.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation.h"
#include "tests/engine/laws/zoo.h"
#include "tests/engine/step/thread_exchange.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kSteps = 12;

/// Models that several processes do not simulate together.
const std::set<std::string_view> kOfOneProcess{
    // loops between subsystems
    "articulated_rotor, a ring of dampers", "helicopter_on_gear, blades tied"};

/// What a run has shown, to the last bit.
struct Shown {
  std::uint64_t hash = 0;
  std::int64_t evaluations = 0;
  std::vector<double> sensors;  ///< of all steps
  friend bool operator==(const Shown&, const Shown&) = default;
};

Shown run(Simulation& simulation) {
  Shown shown;
  simulation.run_until(simulation.scenario().integration.duration,
                       [&shown](double, std::span<const double> values) {
                         shown.sensors.insert(shown.sensors.end(), values.begin(), values.end());
                       });
  shown.hash = simulation.state_hash();
  shown.evaluations = simulation.evaluations();
  return shown;
}

Shown run(const Scenario& scenario, const SimulationOptions& options = {}) {
  Simulation simulation(scenario, options);
  return run(simulation);
}

SimulationOptions by(ExecutorKind kind, const graph::Threads& threads, int window) {
  return {Formulation::structured, kind, threads, window};
}

/// Returns the largest difference of sensors, by the largest value of their unit, beyond what
/// rounding leaves of the largest value of all.
double differ(const Shown& a, const Shown& b, const std::vector<std::string>& units) {
  REQUIRE(a.sensors.size() == b.sensors.size());
  double most = 0.0, largest = 0.0;
  for (const double value : a.sensors) largest = std::max(largest, std::abs(value));
  for (const std::string& unit : units) {
    double size = std::numeric_limits<double>::min(), difference = 0.0;
    for (std::size_t k = 0; k < a.sensors.size(); ++k) {
      if (units[k % units.size()] != unit) continue;
      size = std::max(size, std::abs(a.sensors[k]));
      difference = std::max(difference, std::abs(a.sensors[k] - b.sensors[k]));
    }
    most = std::max(most, (difference - 1e-13 * largest) / size);
  }
  return most;
}

/// Returns the largest residual of the energies of a run, by the largest of what they change by.
double find_energy_residual(const Scenario& scenario) {
  Simulation simulation(scenario, by(ExecutorKind::serial, 1, 1));
  const std::vector<std::string>& names = simulation.sensor_names();
  const auto column_of = [&names](const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), "energy." + name);
    REQUIRE(at != names.end());
    return static_cast<std::size_t>(at - names.begin());
  };
  const std::size_t kinetic = column_of("kinetic"), strain = column_of("strain"),
                    work = column_of("work"), dissipated = column_of("dissipated"),
                    residual = column_of("residual");
  const std::span<const double> at_start = simulation.sensor_values();
  const std::vector<double> start(at_start.begin(), at_start.end());
  double size = 0.0, most = 0.0;
  simulation.run_until(scenario.integration.duration, [&](double, std::span<const double> values) {
    for (const std::size_t k : {kinetic, strain, work, dissipated})
      size = std::max(size, std::abs(values[k] - start[k]));
    most = std::max(most, std::abs(values[residual]));
  });
  return most / size;
}

}  // namespace

TEST_CASE("every model has one state whatever executes its steps, on any threads, in any windows") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    const Scenario scenario = model.read(kSteps);
    const Shown expected = run(scenario, by(ExecutorKind::serial, 1, 1));
    CHECK(expected == run(scenario, by(ExecutorKind::serial, 1, 4)));
    CHECK(expected == run(scenario, by(ExecutorKind::flow_graph, 3, 1)));
    CHECK(expected == run(scenario, by(ExecutorKind::flow_graph, 2, 5)));
    for (const ExecutorKind kind : graph::executor_kinds())
      if (graph::has_nested_teams(kind)) CHECK(expected == run(scenario, by(kind, {2, 1}, 1)));
  }
}

TEST_CASE("the formulations of every model agree") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    const Scenario scenario = model.read(kSteps);
    Simulation simulation(scenario, by(ExecutorKind::serial, 1, 1));
    const Shown structured = run(simulation);
    for (const Formulation formulation : quick_formulations(simulation.size().coordinates)) {
      CAPTURE(name_of(formulation));
      const Shown other = run(scenario, {formulation, ExecutorKind::serial, 1, 1});
      CHECK(differ(structured, other, simulation.sensor_units()) < 1e-5);
    }
  }
}

TEST_CASE("the energies of every model add up to the work, the better the shorter the step") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    Scenario scenario = model.read(2 * kSteps);
    const double coarse = find_energy_residual(scenario);
    scenario.integration.step *= 0.5;
    const double fine = find_energy_residual(scenario);
    CHECK(coarse < 0.02);
    // By a quarter where the step resolves all that moves; less where springs are stiff.
    CHECK(fine < std::max(0.6 * coarse, 2e-5));
  }
}

TEST_CASE(
    "every model goes on from a saved state with the bits of a run that was not interrupted") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    const Scenario scenario = model.read(kSteps);
    Simulation first(scenario, by(ExecutorKind::serial, 1, 1));
    first.run_until(0.5 * scenario.integration.duration);
    const SavedState saved = first.save();
    const Shown expected = run(first);
    Simulation second(scenario, by(ExecutorKind::serial, 1, 1));
    second.restore(saved);
    const Shown resumed = run(second);
    CHECK(resumed.hash == expected.hash);
    CHECK(resumed.sensors == expected.sensors);
    first.restore(saved);
    CHECK(run(first).hash == expected.hash);
  }
}

TEST_CASE("every model of several subsystems has the bits of one process in two") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    const Scenario scenario = model.read(kSteps);
    Simulation alone(scenario, by(ExecutorKind::serial, 1, 1));
    if (alone.size().subsystems < 2 || kOfOneProcess.contains(model.name)) continue;
    const Shown expected = run(alone);
    on_ranks(2, [&](ThreadExchange& exchange) {
      SimulationOptions options = by(ExecutorKind::serial, 1, 1);
      options.exchange = &exchange;
      const Shown shared = run(scenario, options);
      CHECK(shared.hash == expected.hash);
      CHECK(shared.sensors == expected.sensors);
    });
  }
}
