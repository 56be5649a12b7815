// Tests that the angular accelerations of frames, from those of the coordinates, are those that an
// evaluation finds.

#include "engine/bodies/kernels/kinematics.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"
#include "tests/engine/bodies/space/system/random_system.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Takes the accelerations that an evaluation has found as those of the coordinates; those of the
/// hub are there already.
void take_accelerations(StepData<Space>& data) {
  for (SubsystemData<Space>& subsystem : data.subsystems)
    for (BodyData<Space>& body : subsystem.bodies) {
      std::copy_n(body.a_found, body.coordinates.size, body.coordinates.a);
      std::copy_n(body.joint.a_found, body.joint.coordinates.size, body.joint.coordinates.a);
    }
}

void check_angular_accelerations(const System<Space>& system, bool loads_tie_subsystems,
                                 unsigned seed) {
  SystemContext<Space> context;
  context.system = system;
  context.integrator.method = make_generalized_alpha(0.8, 0.01);
  context.loads_tie_subsystems = loads_tie_subsystems;
  allocate(context);
  StepData<Space>& data = context.data;
  for (const auto& tension : context.work.bodies.tensions) tension->least = 0.0;  // at any speed
  std::mt19937 random(seed);
  randomize_state(random, data);
  const graph::StepGraph graph = build_step_graph(context);
  for (StepProgress& progress : data.progress) {
    progress = {};
    progress.control = {0.4, PassControl::kEvaluateOnly, true};
  }
  graph::make_executor(graph, graph::ExecutorKind::serial)->run();
  take_accelerations(data);
  double largest = 0.0, error = 0.0;
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    data.subsystems[i].progress->control = {0.4, PassControl::kEvaluateOnly, true};
    set_angular_accelerations(context.system, i, data);
    for (const BodyData<Space>& body : data.subsystems[i].bodies) {
      const space::Angular expected = angular(body.X);
      largest = std::max(largest, expected.norm());
      error = std::max(error, (body.alpha - expected).norm());
    }
  }
  REQUIRE(largest > 0.0);
  CHECK(error < 1e-9 * largest);
}

/// Makes a mount that goes ahead, swings and turns.
spatial::MountMotion make_mount() {
  return spatial::MountMotion{
      spatial::VectorHarmonic{{0.1, 0.0, 0.4}, {0.0, 0.6, -0.3}, {0.5, 0.2, 0.9}, 2.0, 0.3},
      spatial::VectorHarmonic{{0.1, 0.0, 0.2}, {0.0, 0.3, 0.5}, {0.3, -0.2, 0.1}, 4.0, 0.1}};
}

}  // namespace

TEST_CASE("accelerations of coordinates make the angular ones of frames that an evaluation finds") {
  std::mt19937 random(91);
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const bool is_driven : {true, false})
      for (const bool loads_tie_subsystems : {true, false})
        for (unsigned round = 0; round < 3; ++round) {
          CAPTURE(static_cast<int>(support));
          CAPTURE(is_driven);
          CAPTURE(loads_tie_subsystems);
          check_angular_accelerations(make_random_system({support, is_driven}, random),
                                      loads_tie_subsystems, round);
        }
}

TEST_CASE("a mount that moves is in the angular accelerations of frames, too") {
  std::mt19937 random(92);
  for (const bool is_driven : {true, false})
    for (const bool loads_tie_subsystems : {true, false})
      for (unsigned round = 0; round < 2; ++round) {
        CAPTURE(is_driven);
        CAPTURE(loads_tie_subsystems);
        System<Space> system = make_random_system({HubSupport::axle, is_driven}, random);
        system.hub.mount = make_mount();
        check_angular_accelerations(system, loads_tie_subsystems, round);
      }
}
