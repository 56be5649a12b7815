// An actor that is placed on the table takes part in all that is done with it.

#include "engine/bodies/table/actor.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/bodies/kernels/space/joint_values.h"
#include "engine/bodies/table/state_copy.h"
#include "engine/bodies/table/state_values.h"
#include "engine/simulation/spatial_sensors.h"
#include "engine/step/assembly.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/system/spatial_system.h"
#include "models/tree/tree.h"
#include "tests/engine/bodies/act/delayed_drag.h"
#include "tests/engine/step/damaged_graph.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kStep = 5e-3;  // [s]

/// A shipped rotor in steps of generalized_alpha, whether the actor is on it or not.
struct DraggedRotor {
  explicit DraggedRotor(bool is_dragged = true, Formulation formulation = Formulation::structured) {
    context.system = make_system(*read_shipped("nrel_5mw_rotor").space);
    context.formulation = formulation;
    context.integrator = {make_generalized_alpha(0.8, kStep), {1e-10, 0, 50}};
    allocate(context);
    if (is_dragged) add_delayed_drag(context);
    graph.emplace(context.build_whole_graph());
    executor = graph::make_executor(*graph, graph::ExecutorKind::serial, 1);
    stepper.emplace(context, *graph);
    REQUIRE(stepper->start() == StepOutcome::done);
  }
  std::vector<double> state_after(std::int64_t step) {
    REQUIRE(stepper->advance(step, *executor) == StepOutcome::done);
    return take_state_values(step, context.data);
  }

  SystemContext<Space> context;
  std::optional<graph::StepGraph> graph;
  std::unique_ptr<graph::Executor> executor;
  std::optional<TimeStepper> stepper;
};

}  // namespace

TEST_CASE("a step with an actor reads and writes what its nodes declare") {
  for (const Formulation formulation :
       {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
    DraggedRotor rotor(true, formulation);
    const graph::StepGraph graph = build_step_graph(rotor.context);
    for (const int stage : {0, 1, PassControl::kEvaluateOnly}) {
      set_progress({0.1, stage, stage >= 0}, rotor.context);
      for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
        FAIL_CHECK(fault.message);
    }
    CHECK(role_of("delayed drag", rotor.context.data) == StageRole::terms);
  }
}

TEST_CASE("the delayed states of an actor are set back with the state, and saved with it") {
  DraggedRotor rotor;
  const std::vector<double> before = rotor.state_after(3);
  StateCopy copy(rotor.context.table());
  copy.save();
  const std::vector<double> expected = rotor.state_after(8);
  const std::size_t states = rotor.context.data.subsystems.size() * (3 + 1);
  CHECK(before.size() == DraggedRotor(false).state_after(3).size() + states);
  copy.restore();
  rotor.stepper->continue_from(3);
  CHECK(rotor.state_after(8) == expected);
  DraggedRotor other;
  other.context.data.put_state(before, 3);
  other.stepper->continue_from(3);
  CHECK(other.state_after(8) == expected);
}

TEST_CASE("the end of a step keeps the delayed states that its last evaluation has reached") {
  DraggedRotor rotor;
  const SubsystemData<Space>& own = rotor.context.data.subsystems[0];
  const StatePair& pair = *own.delayed[0];
  const PlacedMarker<Space> tip = place_marker("the tip", {0, 0, 1.0}, rotor.context.data);
  const double share = 1.0 - std::exp(-kStep / DelayedDrag::kDelay);
  for (std::int64_t step = 1; step <= 10; ++step) {
    const std::vector<double> before(pair.kept.begin(), pair.kept.end());
    const bool begun = pair.has_begun();
    rotor.state_after(step);
    CHECK(pair.has_begun());
    const MarkerMotion motion = calc_load_motion(rotor.context.system.subsystems[0], own, tip);
    // The last correction moves the blade once more, by little beside what the states go on by.
    const double allowed = 1e-4 * motion.velocity.norm();
    for (std::size_t c = 0; c < 3; ++c) {
      const double v = motion.velocity[static_cast<int>(c)];
      const double expected = begun ? before[c] + share * (v - before[c]) : v;
      CHECK(std::abs(pair.kept[c] - expected) < allowed);
    }
  }
}

namespace {

/// Runs a rotor whose blades go through a window of so many steps on their own. Returns the values
/// of the actor's columns at each step, and checks the last ones.
std::vector<double> show_drag(int window) {
  constexpr std::int64_t kSteps = 12;
  const Scenario scenario = read_shipped("nrel_5mw_rotor");
  const std::vector<spatial::Tree> trees = build_trees(*scenario.space);
  SystemContext<Space> context;
  context.system = make_system(*scenario.space, trees);
  context.integrator = {make_generalized_alpha(0.8, kStep), {1e-10, 0, 50}};
  allocate(context, window);
  add_delayed_drag(context);
  for (std::size_t i = 0; i < context.data.subsystems.size(); ++i)
    context.data.subsystems[i].reading_count = count_own_values(context.system, i, context.data);
  make_reading_rings(context.data);
  SpatialSensors sensors(context.system, trees, context.data, {});
  REQUIRE(sensors.names().back() == "drag.z");
  const graph::StepGraph graph = context.build_whole_graph();
  const graph::StepGraph passes = context.build_graph(3 * window);
  const auto executor = graph::make_executor(passes, graph::ExecutorKind::serial, 1);
  TimeStepper stepper(context, graph);
  REQUIRE(stepper.start() == StepOutcome::done);
  std::vector<double> shown;
  REQUIRE(stepper.advance(kSteps, *executor, true, [&](std::int64_t step) {
    const std::vector<double>& values = sensors.measure(context.system, {}, step, context.data);
    shown.insert(shown.end(), values.end() - 3, values.end());
  }) == StepOutcome::done);
  double sum = 0.0;
  for (const SubsystemData<Space>& own : context.data.subsystems)
    sum -= DelayedDrag::kDrag * own.delayed[0]->kept[2];
  CHECK(shown.back() == sum);
  CHECK(shown.size() == 3 * kSteps);
  return shown;
}

}  // namespace

TEST_CASE("sensors show the columns of an actor, of one step although subsystems are at others") {
  CHECK(show_drag(4) == show_drag(1));
}
