// The nodes of step graphs in space declare what they read and write.

#include <doctest/doctest.h>

#include <random>

#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/random_system.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/damaged_graph.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kDamping = "[damping]\nstiffness_factor = 1e-4\n";
const std::string kHubLoads = R"(
[[hub_load]]
position = [0.1, 0.2, 0.3]
force = [1.0, 2.0, 3.0]
[[hub_load]]
frame = "inertial"
torque = [0.4, 0.5, 0.6]
)";

const std::string kStrutOfTower = R"(
[[support.loop]]
name = "strut"
kind = "distance"
from = { body = "nacelle", point = [0.2, 0.3, 0.1] }
to = { body = "ground", point = [1.0, 1.5, -0.5] }
)";

struct Case {
  const char* name;
  std::string text;
  Method method;
  std::vector<PassControl> controls;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  const std::pair<const char*, std::string> models[] = {
      {"booms, driven", make_text(kDrivenHub, kBooms, kGravity + kDamping)},
      {"blades, driven",
       make_text(kDrivenHub, kBooms + kHinges + kPitch, kRisingGravity + kDamping)},
      {"blades, turned", make_text(kTurnedHub, kBooms + kHinges, kRisingGravity + kHubLoads)},
      {"blades in air, driven", make_text(kDrivenHub, kBooms + kAir, kGravity)},
      {"blades in air, turned", make_text(kTurnedHub, kBooms + kPitch + kAir, kGravity)},
      {"blades in air on a tower", make_text(kTurnedHub, kBooms + kAir, kTower)},
      {"controlled blades, driven", make_text(kDrivenHub, kBooms + kControlledPitch)},
      {"controlled blades, turned", make_text(kTurnedHub, kBooms + kControlledPitch)},
      {"controlled blades on a tower", make_text(kTurnedHub, kBooms + kControlledPitch, kTower)},
      {"tree, free", make_text(kFlyingHub, kTree + kMotors, kGravity + kDamping + kHubLoads)},
      {"forest, turned", make_text(kTurnedHub, kForest, kGravity + kDamping)},
      {"blades on a tower",
       make_text(kTurnedHub, kBooms + kHinges + kPitch, kTower + kRisingGravity + kHubLoads)},
      {"blades on a tower with a strut", make_text(kDrivenHub, kBooms, kTower + kStrutOfTower)},
      {"blades on a fuselage", make_text(kFuselageHub, kBooms + kHinges, kDamping + kHubLoads)},
      {"motors, driven",
       make_text(kDrivenHub, kMotors + kTree + kForest, kRisingGravity + kDamping)},
      {"blades with strains of second order, turned",
       with_nonlinear_strains(make_text(kTurnedHub, kBooms + kHinges, kRisingGravity + kDamping))},
      {"tree with strains of second order, free",
       with_nonlinear_strains(make_text(kFlyingHub, kTree + kMotors, kGravity + kDamping))}};
  for (const auto& [name, text] : models) {
    cases.push_back({name, text, Rk4{1e-5}, {{0.1, 1, false}, {0.1, 2, false}, {0.1, 0, false}}});
    cases.push_back({name,
                     text,
                     make_generalized_alpha(0.8, 0.005),
                     {{0.1, 0, true}, {0.1, 1, true}, {0.1, -1, false}}});
  }
  return cases;
}

void prepare(const Case& which, Formulation formulation, SystemContext<Space>& context) {
  context.system = make_system(parse_model(which.text));
  context.formulation = formulation;
  context.integrator = {which.method, {1e-10, 0, 50}};
  allocate(context);
  std::mt19937 random(4);
  randomize_state(random, context.data);
}

}  // namespace

TEST_CASE("every node of a step graph in space declares what it reads and writes") {
  for (const Case& which : all_cases())
    for (const Formulation formulation : formulations())
      for (const PassControl& control : which.controls) {
        CAPTURE(which.name);
        CAPTURE(name_of(formulation));
        SystemContext<Space> context;
        prepare(which, formulation, context);
        const graph::StepGraph graph = build_step_graph(context);
        set_progress(control, context);
        for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
          FAIL_CHECK(fault.message);
        CHECK(graph::conflicts_are_ordered(graph));
      }
}
