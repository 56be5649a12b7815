// After 500 steps a model has one state per formulation, to the last bit: with every executor,
// number of threads, window and plan. Takes long; executor_test.cpp and window_test.cpp look at
// fewer steps, and at more kinds of models.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/bodies/table/state_values.h"
#include "engine/simulation.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"
#include "graph/execute/executor_kinds.h"
#include "graph/tune/plan_candidates.h"
#include "tests/shipped.h"

using namespace spoke;

namespace {

constexpr int kSteps = 500;

enum class HubDrive { motion, torque };

/// The paper's rotor; gravity, so that no two of its equal blades move alike.
Scenario make_scenario(HubDrive drive, int bodies = 4, int elements = 4) {
  Scenario scenario = test::read_shipped(
      "wu_haug_rotor",
      {"blade.bodies=" + std::to_string(bodies), "blade.elements=" + std::to_string(elements)});
  scenario.rotor.gravity = Position{0.0, -0.5};
  if (drive == HubDrive::torque) scenario.rotor.hub.drive = TorqueDrive{Curve(20.0), 0.5};
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// Result of a run.
struct End {
  std::int64_t steps = 0;
  std::uint64_t hash = 0;
  std::int64_t evaluations = 0;
  friend bool operator==(const End&, const End&) = default;
};

End run(const Scenario& scenario, const SimulationOptions& options) {
  Simulation simulation(scenario, options);
  simulation.run_until(scenario.integration.duration);
  return {simulation.steps(), simulation.state_hash(), simulation.evaluations()};
}

std::vector<graph::Threads> thread_counts(ExecutorKind kind) {
  if (kind == ExecutorKind::serial) return {1};
  std::vector<graph::Threads> list{1, 2, 3, 6, 12};
  if (graph::has_nested_teams(kind)) list.insert(list.end(), {{1, 2}, {2, 2}, {3, 2}, {3, 4}});
  return list;
}

/// Returns the windows to test. 7 divides nothing. `automatic` chooses for itself with 0, and needs
/// windows to plan at all. Inner teams meet so often that a busy machine takes seconds for a run:
/// two windows suffice.
std::vector<int> windows(ExecutorKind kind, const graph::Threads& threads) {
  if (kind == ExecutorKind::automatic) return {0, 7, 50};
  if (threads.inner > 1) return {1, 7};
  return {1, 7, 50};
}

void check_executors(const Scenario& scenario, Formulation formulation) {
  const End expected = run(scenario, {formulation, ExecutorKind::serial, 1, 1});
  CHECK(expected.steps == kSteps);
  for (const ExecutorKind kind : graph::executor_kinds())
    for (const graph::Threads& threads : thread_counts(kind))
      for (const int window : windows(kind, threads)) {
        CAPTURE(name_of(kind));
        CAPTURE(name_of(threads));
        CAPTURE(window);
        CHECK(expected == run(scenario, {formulation, kind, threads, window}));
      }
}

/// Makes the same steps by one executor after the other, on the step graph of a window.
class Repetition {
 public:
  Repetition(const Scenario& scenario, Formulation formulation, int window)
      : context_(prepare(scenario, formulation, window)),
        single_(build_step_graph(*context_)),
        graph_(build_step_graph(*context_, window * usual_passes(context_->integrator))),
        stepper_(*context_, single_) {
    REQUIRE(stepper_.start() == StepOutcome::done);
    start_ = take_state_values(0, context_->data);
  }
  const graph::StepGraph& graph() const { return graph_; }

  /// Returns the state in which the steps end.
  std::vector<double> run(graph::Executor& executor) {
    context_->data.put_state(start_, 0);
    stepper_.continue_from(0);
    REQUIRE(stepper_.advance(kSteps, executor) == StepOutcome::done);
    return take_state_values(kSteps, context_->data);
  }

 private:
  static std::unique_ptr<SystemContext<Plane>> prepare(const Scenario& scenario,
                                                       Formulation formulation, int window) {
    const Integration& integration = scenario.integration;
    auto context = std::make_unique<SystemContext<Plane>>();
    context->system = make_system(scenario.rotor);
    context->formulation = formulation;
    context->integrator = {
        make_generalized_alpha(integration.spectral_radius, integration.step),
        {integration.tolerance, integration.iterations, integration.max_iterations, false,
         goal_of(integration) == IterationGoal::error}};
    allocate(*context, window > 1 ? 2 * window : 1);
    return context;
  }

  std::unique_ptr<SystemContext<Plane>> context_;
  graph::StepGraph single_, graph_;
  TimeStepper stepper_;
  std::vector<double> start_;
};

/// Returns possible costs of nodes [s].
std::vector<double> invent_costs(const graph::StepGraph& graph, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> cost(0.1e-6, 20e-6);
  std::vector<double> costs(static_cast<std::size_t>(graph.node_count()));
  std::generate(costs.begin(), costs.end(), [&] { return cost(random); });
  return costs;
}

void check_plans(const Scenario& scenario, Formulation formulation) {
  Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 1});
  simulation.run_until(scenario.integration.duration);
  std::vector<double> expected = simulation.save().values;
  int plans = 0;
  for (const int window : {1, 7}) {
    Repetition repetition(scenario, formulation, window);
    const auto serial = graph::make_executor(repetition.graph(), ExecutorKind::serial);
    const std::vector<double> alone = repetition.run(*serial);
    expected.resize(alone.size());  // behind the state stand observations
    CHECK(expected == alone);
    for (const int processors : {2, 3, 6, 12}) {
      const graph::Overheads overheads{2e-9, 0.2e-6, 1e-6};
      const auto costs = invent_costs(repetition.graph(), static_cast<std::uint32_t>(processors));
      for (graph::Candidate& candidate :
           graph::find_candidates(repetition.graph(), costs, processors, overheads, 6)) {
        CAPTURE(window);
        CAPTURE(processors);
        CAPTURE(candidate.plan.cluster_count());
        const auto executor = graph::make_flow_graph_executor(
            repetition.graph(), std::move(candidate.plan), processors);
        CHECK(expected == repetition.run(*executor));
        ++plans;
      }
    }
  }
  CHECK(plans >= 20);
}

void check_all(const Scenario& scenario, Formulation formulation) {
  check_executors(scenario, formulation);
  check_plans(scenario, formulation);
}

}  // namespace

TEST_CASE("one state after 500 steps: structured with a prescribed hub") {
  check_all(make_scenario(HubDrive::motion), Formulation::structured);
}

TEST_CASE("one state after 500 steps: structured with a hub driven by a torque") {
  check_all(make_scenario(HubDrive::torque), Formulation::structured);
}

TEST_CASE("one state after 500 steps: subsystem with a prescribed hub") {
  check_all(make_scenario(HubDrive::motion), Formulation::subsystem);
}

TEST_CASE("one state after 500 steps: subsystem with a hub driven by a torque") {
  check_all(make_scenario(HubDrive::torque), Formulation::subsystem);
}

// One dense system has all coordinates: with 144 as above a run takes many seconds.
TEST_CASE("one state after 500 steps: augmented with a prescribed hub") {
  check_all(make_scenario(HubDrive::motion, 2, 1), Formulation::augmented);
}

TEST_CASE("one state after 500 steps: augmented with a hub driven by a torque") {
  check_all(make_scenario(HubDrive::torque, 2, 1), Formulation::augmented);
}
