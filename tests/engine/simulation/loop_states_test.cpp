// Runs of models with loops: saved and restored, in windows, by several threads, recorded.

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/checkpoint.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/system/spatial_system.h"
#include "tests/engine/loop_models.h"
#include "tests/message_of.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kHubs[] = {"drive = { kind = \"constant\", speed = 5.0 }",
                             "mass = 3.0\ninertia = 0.8\n"
                             "drive = { kind = \"torque\", torque = 3.0, initial_speed = 4.0 }"};

/// Makes two blades on a plate that moves, each with a rod besides that gives, from the horn to the
/// hub.
Scenario make_blades(const std::string& hub, IntegrationMethod method) {
  Scenario scenario = make_pitching(hub, 2);
  scenario.integration.method = method;
  spatial::MountMotion shaken;
  shaken.translation = spatial::VectorHarmonic{
      .amplitude = spatial::Vector(0.0, 0.0, 0.02), .frequency = 9.0, .phase = 0.0};
  shaken.rotation =
      spatial::VectorHarmonic{.amplitude = spatial::Vector(0.05, 0.1, 0.0), .frequency = 7.0};
  scenario.space->anchors[0].motion = shaken;
  for (spatial::Subsystem& blade : scenario.space->subsystems) {
    Loop spring;
    spring.name = "spring";
    spring.kind = LoopKind::distance;
    spring.from = place_on("horn", {0.4, 0.1, 0.1});
    spring.to = place_on(LoopPlace::Carrier::hub, {0.4, 0.5, 0.0});
    spring.stiffness = {50.0};
    spring.damping = {0.5};
    blade.loops.push_back(spring);
    for (const Loop& loop : blade.loops)
      for (const SensorQuantity quantity :
           {SensorQuantity::loop_reaction, SensorQuantity::loop_opening})
        scenario.sensors.push_back(loop_sensor(quantity, loop.name + std::string(name_of(quantity)),
                                               blade.name, loop.name, SensorFrame::inertial));
  }
  return scenario;
}

template <class Check>
void for_all_blades(Check&& check) {
  for (const std::string& hub : kHubs)
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha})
      for (const Formulation formulation :
           {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
        CAPTURE(hub);
        CAPTURE(name_of(method));
        CAPTURE(name_of(formulation));
        check(make_blades(hub, method), formulation);
      }
}

}  // namespace

TEST_CASE("a run with loops goes on from a checkpoint with the bits of the whole run") {
  for_all_blades([](const Scenario& scenario, Formulation formulation) {
    const SimulationOptions options{formulation, ExecutorKind::serial, 1, 1};
    Simulation whole(scenario, options);
    whole.run_until(0.1);
    const std::string checkpoint = make_checkpoint(whole.save());
    const std::vector<double> shown = values_of(whole);
    whole.run_until(0.2);
    Simulation other(scenario, options);
    other.restore(parse_checkpoint(checkpoint, "test").state);
    CHECK(values_of(other) == shown);
    other.run_until(0.2);
    CHECK(other.state_hash() == whole.state_hash());
    CHECK(values_of(other) == values_of(whole));
  });
}

TEST_CASE("a state whose nearest loop is one that there is not is refused") {
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1, 1};
  Simulation simulation(make_pitching("drive = { kind = \"constant\", speed = 5.0 }", 2), options);
  simulation.run_until(0.1);
  // The last five values of a state: Observations::Loop.
  for (const auto& [subsystem, row] :
       {std::pair{-1.0, 0.0}, std::pair{1e300, 0.0}, std::pair{0.0, 1e9}, std::pair{0.5, 0.0}}) {
    SavedState state = simulation.save();
    const std::size_t last = state.values.size() - 5;
    state.values[last + 1] = 3.0;  // the step
    state.values[last + 3] = subsystem;
    state.values[last + 4] = row;
    CHECK(message_of([&] { simulation.restore(state); }) ==
          "the saved state names a body or a loop that there is not");
  }
}

TEST_CASE("windows, threads and observers change no bits of a run with loops") {
  for_all_blades([](const Scenario& scenario, Formulation formulation) {
    Simulation expected(scenario, {formulation, ExecutorKind::serial, 1, 1});
    expected.run_until(0.2);
    for (const ExecutorKind kind : {ExecutorKind::serial, ExecutorKind::flow_graph}) {
      Simulation other(scenario, {formulation, kind, kind == ExecutorKind::serial ? 1 : 2, 7});
      other.run_until(0.2, [](double, std::span<const double>) {});
      CHECK(other.state_hash() == expected.state_hash());
      CHECK(values_of(other) == values_of(expected));
    }
  });
}

TEST_CASE("nodes of models with loops and sensors on them keep to what they declare") {
  for_all_blades([](const Scenario& scenario, Formulation formulation) {
    const bool is_implicit = scenario.integration.method == IntegrationMethod::generalized_alpha;
    SystemContext<Space> context;
    const std::vector<spatial::Tree> trees = build_trees(*scenario.space);
    context.system = make_system(*scenario.space, trees);
    context.formulation = formulation;
    // The second iteration, or the last stage, completes a step.
    context.integrator = {is_implicit ? make_generalized_alpha(0.8, 0.005) : Method{Rk4{0.005}},
                          {1e9, 2, 50}};
    allocate(context);
    place_sensors(scenario.sensors, 0, trees, context.system, context.data);
    make_reading_rings(context.data);
    const graph::StepGraph graph = build_step_graph(context);
    for (StepProgress& progress : context.data.progress) {
      progress.control = {0.1, is_implicit ? 1 : 0, is_implicit};
      progress.step = 20;
      progress.passes = 1;
    }
    context.data.window = {20, 20, true};
    for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
      FAIL_CHECK(fault.message);
    CHECK(graph::conflicts_are_ordered(graph));
    CHECK(context.data.progress[0].completed == 20);
  });
}

TEST_CASE("each loop has nodes of its own in a trace, by its name") {
  for_all_blades([](const Scenario& scenario, Formulation formulation) {
    Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 1});
    const StepTrace trace = simulation.trace(3);
    const std::set<std::string> names(trace.graph.names.begin(), trace.graph.names.end());
    CHECK(names.size() == trace.graph.names.size());
    CHECK(trace.graph.node_count() == simulation.step_graph().node_count());
    CHECK(names.contains("bladeB / loop motion"));
    CHECK(names.contains("bladeB / loop forces"));
    for (const char* loop : {"link", "spring"})
      CHECK(names.contains("bladeA / " + std::string(loop) + " / loop columns") ==
            (formulation != Formulation::augmented));
    int passes = 0;
    for (const TracedStep& step : trace.steps) passes += step.passes;
    int columns = 0;
    for (const NodeSlice& slice : trace.slices)
      columns += slice.step >= 0 && trace.graph.names[static_cast<std::size_t>(slice.node)] ==
                                        "bladeA / spring / loop columns";
    if (formulation != Formulation::augmented) CHECK(columns > 0);
    CHECK(columns <= passes);
  });
}

TEST_CASE("the size of a model says its loops, and the freedoms that they leave") {
  for (const bool is_turned : {false, true}) {
    // Of each blade the link locks the pitch; the spring locks nothing.
    const Simulation simulation(make_blades(kHubs[is_turned], IntegrationMethod::rk4),
                                {Formulation::structured, ExecutorKind::serial, 1, 1});
    CHECK(simulation.size().coordinates == (is_turned ? 3 : 2));
    CHECK(simulation.size().loops == 4);
    CHECK(simulation.size().freedoms == (is_turned ? 1 : 0));
  }
}
