// A state that is set back is whole: steps from it are the same bits, whatever
// else the table held.

#include "engine/bodies/table/state_copy.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "engine/bodies/table/state_values.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_context.h"
#include "graph/executor.h"
#include "models/system/spatial_system.h"
#include "tests/engine/laws/zoo.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Overwrites all parts that are not set back, but for tension: it has constants besides, and is
/// made anew for the speed of the first pass.
void poison_others(const graph::StepGraph& graph, StepTable& table) {
  std::set<const std::byte*> kept;
  for (const std::span<std::byte> range : table.state_memory()) kept.insert(range.data());
  for (const graph::Part& part : graph.parts()) {
    if (part.name.ends_with("tension")) continue;
    for (const std::span<std::byte> range : part.memory)
      if (!kept.contains(range.data()))
        std::fill(range.begin(), range.end(), std::byte{0xff});  // not a number
  }
}

/// Goes on from a step, and returns the state some steps later.
std::vector<double> go_on(std::int64_t from, graph::Executor& executor, TimeStepper& stepper,
                          StepTable& table) {
  stepper.continue_from(from);
  REQUIRE(stepper.advance(from + 4, executor) == StepOutcome::done);
  return take_state_values(from + 4, table);
}

template <class World>
void check_copy(const System<World>& system, Formulation formulation, const Method& method) {
  constexpr std::int64_t kFrom = 5;
  SystemContext<World> context;
  context.system = system;
  context.formulation = formulation;
  context.integrator = {method, {1e-10, 0, 50}};
  allocate(context);
  const graph::StepGraph graph = context.build_whole_graph();
  const auto executor = graph::make_executor(graph, graph::ExecutorKind::serial, 1);
  TimeStepper stepper(context, graph);
  REQUIRE(stepper.start() == StepOutcome::done);
  REQUIRE(stepper.advance(kFrom, *executor) == StepOutcome::done);
  StateCopy copy(context.table());
  copy.save();
  const std::vector<double> expected = go_on(kFrom, *executor, stepper, context.data);
  poison_others(graph, context.data);
  copy.restore();
  CHECK(go_on(kFrom, *executor, stepper, context.data) == expected);
}

template <class World>
void check_copies(const System<World>& system, double step) {
  for (const Formulation formulation : quick_formulations(system.deformation_count())) {
    CAPTURE(name_of(formulation));
    check_copy(system, formulation, make_generalized_alpha(0.8, step));
  }
  check_copy(system, Formulation::structured, Rk4{5e-11});
}

}  // namespace

TEST_CASE("steps of every model from a state that is set back need nothing else of the table") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    on_system(model.read(1), [](const auto& system, double step) { check_copies(system, step); });
  }
}
