// A run in space ends in the same bits whatever executes it, and wherever it is interrupted.

#include <doctest/doctest.h>

#include "engine/bodies/table/state_values.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kSteps = 15;  // two windows of 7, and one

struct EqualStatesCase {
  const char* name;
  System<Space> system;
  Method method;
};

std::vector<EqualStatesCase> equal_states_cases() {
  std::vector<EqualStatesCase> cases;
  const std::pair<const char*, std::string> models[] = {
      {"blades, driven", make_text(kDrivenHub, kBooms + kHinges + kPitch, kGravity)},
      {"blades, turned", make_text(kTurnedHub, kBooms + kHinges, kRisingGravity)},
      {"controlled blades, driven", make_text(kDrivenHub, kBooms + kControlledPitch, kGravity)},
      {"controlled blades, turned", make_text(kTurnedHub, kBooms + kControlledPitch, kGravity)},
      {"controlled blades on a tower", make_text(kTurnedHub, kBooms + kControlledPitch, kTower)},
      {"tree, free", make_text(kFlyingHub, kTree + kMotors, kGravity)},
      {"trees, driven", make_text(kDrivenHub, kMotors + kTree, kGravity)},
      {"tree with strains of second order, free",
       with_nonlinear_strains(make_text(kFlyingHub, kTree + kMotors, kGravity))}};
  for (const auto& [name, text] : models)
    for (const Method& method : {Method{Rk4{1e-3}}, Method{make_generalized_alpha(0.8, 5e-3)}})
      cases.push_back({name, make_system(parse_model(text)), method});
  return cases;
}

std::uint64_t end_of(const EqualStatesCase& which, const RunSetup& setup) {
  Run<Space> run(which.system, setup);
  run.advance(kSteps);
  return run.hash();
}

}  // namespace

TEST_CASE("a run in space has one state, whatever executes it") {
  using Kind = graph::ExecutorKind;
  for (const EqualStatesCase& which : equal_states_cases())
    for (const Formulation formulation : formulations()) {
      CAPTURE(which.name);
      CAPTURE(name_of(formulation));
      RunSetup setup{which.method, 1e-10};
      setup.formulation = formulation;
      const std::uint64_t expected = end_of(which, setup);
      for (const Kind kind : {Kind::serial, Kind::flow_graph, Kind::openmp_levels,
                              Kind::openmp_scheme1, Kind::openmp_tasks})
        for (const int window : {1, 7}) {
          CAPTURE(name_of(kind));
          CAPTURE(window);
          setup.executor = kind;
          setup.threads = {kind == Kind::serial ? 1 : 2};
          setup.window = window;
          CHECK(expected == end_of(which, setup));
        }
    }
}

TEST_CASE("a run in space goes on from a state that was taken as if it had not been interrupted") {
  for (const EqualStatesCase& which : equal_states_cases()) {
    CAPTURE(which.name);
    const RunSetup setup{which.method, 1e-10};
    Run<Space> whole(which.system, setup);
    whole.advance(kSteps);
    for (const int split : {0, 1, 13}) {
      Run<Space> first(which.system, setup), second(which.system, setup);
      first.advance(split);
      const std::vector<double> state = take_state_values(split, first.context.data);
      second.context.data.put_state(state, split);
      second.runner->continue_from(split);
      second.advance(kSteps - split);
      CHECK(second.hash() == whole.hash());
      CHECK(take_state_values(kSteps, second.context.data) ==
            take_state_values(kSteps, whole.context.data));
      CHECK(second.trace.back() == whole.trace.back());
    }
  }
}
