// Runs some steps serially, and chooses from their time how many make a sample.

#include "bench/compare/probe.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/simulation/node_measurement.h"

namespace spoke::compare {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kWarmUpSteps = 3;
constexpr double kLongEnough = 0.02;  // least duration of a timed batch [s]

/// Returns the time per step [s]. The batch doubles until it takes long enough, or the steps end.
double time_step(Simulation& simulation) {
  const double h = simulation.step_size();
  simulation.run_until(static_cast<double>(kWarmUpSteps) * h);
  for (std::int64_t batch = 1;; batch *= 2) {
    const std::int64_t before = simulation.steps();
    const auto begin = Clock::now();
    simulation.run_until(simulation.time() + static_cast<double>(batch) * h);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    const std::int64_t done = simulation.steps() - before;
    if (seconds > kLongEnough || simulation.steps() + 2 * batch > simulation.planned_steps())
      return seconds / static_cast<double>(done);
  }
}

}  // namespace

Scenario with_steps(const Simulation& simulation, std::int64_t steps) {
  Scenario scenario = simulation.scenario();
  if (steps <= simulation.planned_steps()) return scenario;
  scenario.integration.step = simulation.step_size();
  scenario.integration.duration = simulation.step_size() * static_cast<double>(steps);
  return scenario;
}

Model probe(const Scenario& scenario, Formulation formulation, double sample_seconds) {
  constexpr std::int64_t kFewSteps = 1000;
  constexpr double kCostSeconds = 0.3;  // approximate time spent on the costs of nodes
  constexpr double kMostSteps = 1e6;
  const SimulationOptions options{
      .formulation = formulation, .executor = ExecutorKind::serial, .threads = 1};
  Simulation simulation(scenario, options);
  if (simulation.planned_steps() < kFewSteps)
    simulation = Simulation(with_steps(simulation, kFewSteps), options);
  const double step = time_step(simulation);
  Model model{.formulation = formulation, .size = simulation.size()};
  model.batch = std::llround(std::clamp(sample_seconds / step, 1.0, kMostSteps));
  const auto steps = static_cast<std::int64_t>(std::clamp(kCostSeconds / step, 5.0, 201.0));
  if (simulation.steps() + steps > simulation.planned_steps())
    simulation = Simulation(with_steps(simulation, steps), options);
  model.pass = calc_work_and_span(simulation.run_graph(), measure_nodes(simulation, steps).costs);
  return model;
}

}  // namespace spoke::compare
