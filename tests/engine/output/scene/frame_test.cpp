#include "engine/output/scene/frame.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/output/scene/make_scene.h"
#include "models/space/rotation_vector.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::scene;
using namespace spoke::test;
using spatial::Tensor;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1};

Scenario scenario_of(const std::string& hub, const std::string& bodies) {
  Scenario scenario = parse_scenario(make_text(hub, bodies, kGravity), "test");
  scenario.integration.step = 1e-3;
  return scenario;
}

Frame frame_of(const Simulation& simulation, const Scene& scene) {
  Frame frame;
  FrameReader(scene).read(simulation, frame);
  return frame;
}

/// Checks that the frame of a scenario is that of the simulation at its start.
void check_first_frame(const Scenario& scenario) {
  const Scene scene = make_scene(scenario, 1000);
  const Frame drawn = make_first_frame(scenario, scene);
  const Frame simulated = frame_of(Simulation(scenario, kSerial), scene);
  REQUIRE(drawn.groups.size() == simulated.groups.size());
  for (std::size_t g = 0; g < drawn.groups.size(); ++g) {
    CAPTURE(g);
    CHECK((drawn.groups[g].rotation - simulated.groups[g].rotation).norm() < 1e-12);
    CHECK((drawn.groups[g].position - simulated.groups[g].position).norm() < 1e-12);
  }
  for (std::size_t k = 0; k < scene.nodes.size(); ++k)
    CHECK((drawn.place(scene, k) - simulated.place(scene, k)).norm() < 1e-12);
}

}  // namespace

TEST_CASE("groups, displacements and rotations of a frame make the places of the nodes") {
  for (const auto& [hub, bodies] :
       {std::pair{kFlyingHub, kTree}, std::pair{kFlyingHub, kMotors + kForest},
        std::pair{kTurnedHub, kBooms + kHinges}, std::pair{kDrivenHub, kBooms + kPitch}}) {
    const Scenario scenario = scenario_of(hub, bodies);
    const Scene scene = make_scene(scenario, 1000);
    Simulation simulation(scenario, kSerial);
    simulation.run_until(0.4);
    const Frame frame = frame_of(simulation, scene);
    double deformed = 0.0;
    for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
      const NodeSource& source = scene.sources[k];
      TreeShape shape;
      simulation.calc_shape(source.subsystem, shape);
      const TreeNode& node = shape.bodies[static_cast<std::size_t>(source.body)]
                                 .nodes[static_cast<std::size_t>(source.node)];
      CHECK((frame.place(scene, k) - node.p).norm() < 1e-12);
      const auto group = static_cast<std::size_t>(scene.nodes[k].group);
      const Tensor turned = space::exponential(frame.rotations[k]).axes *
                            frame.groups[group].rotation * scene.nodes[k].axes;
      CHECK((turned - node.R).norm() < 1e-12);
      deformed = std::max(deformed, frame.displacements[k].norm());
    }
    CHECK(deformed > 1e-4);
    CHECK(frame.groups[0].rotation == Tensor::Identity());
  }
}

TEST_CASE("frames place a support by its base, and the rotor by its hub") {
  for (const auto& [hub, bodies] :
       {std::pair{kTurnedHub, kBooms + kTower}, std::pair{kFuselageHub, kBooms + kHinges}}) {
    const Scenario scenario = scenario_of(hub, bodies);
    const Scene scene = make_scene(scenario, 1000);
    Simulation simulation(scenario, kSerial);
    simulation.run_until(0.4);
    const Frame frame = frame_of(simulation, scene);
    const MarkerMotion base = simulation.base_frame();
    const auto support = static_cast<int>(scenario.space->blades.size());
    for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
      const NodeSource& source = scene.sources[k];
      TreeShape shape;
      simulation.calc_shape(source.subsystem, shape);
      const Vector p = shape.bodies[static_cast<std::size_t>(source.body)]
                           .nodes[static_cast<std::size_t>(source.node)]
                           .p;
      const Vector expected = source.subsystem == support
                                  ? Vector(base.position + base.rotation * p)
                                  : Vector(frame.hub.position + frame.hub.rotation * p);
      const Vector drawn = frame.hub.position + frame.hub.rotation * frame.place(scene, k);
      CHECK((drawn - expected).norm() < 1e-12);
    }
    // The hub is where the last body of the support is.
    const MarkerState end =
        simulation.marker({support, static_cast<int>(simulation.size().bodies - 4) - 1, 0.0});
    CHECK((end.position - frame.hub.position).norm() < 1e-12);
  }
}

TEST_CASE("the first frame is what a simulation begins with") {
  for (const auto& [hub, bodies] :
       {std::pair{kFlyingHub, kTree}, std::pair{kFlyingHub, kMotors + kForest},
        std::pair{kTurnedHub, kBooms + kHinges}, std::pair{kDrivenHub, kBooms + kPitch},
        std::pair{kTurnedHub, kBooms + kTower}, std::pair{kFuselageHub, kBooms}})
    check_first_frame(scenario_of(hub, bodies));
  Scenario rotors = read_shipped("quadcopter");
  rotors.space->support->fuselage.attitude = {0.1, -0.2, 0.3};
  check_first_frame(rotors);
}

TEST_CASE("frames of a planar rotor have the blades' shapes and forces") {
  const Scenario scenario = read_shipped("wu_haug_rotor");
  const Scene all = make_scene(scenario, 1000), part = make_scene(scenario, 30);
  Simulation simulation(scenario, kSerial);
  simulation.run_until(4.0);
  const Frame frame = frame_of(simulation, all), coarse = frame_of(simulation, part);
  BladeShape blade;
  simulation.calc_shape(1, blade);
  const Strip& strip = all.strips[static_cast<std::size_t>(blade.bodies)];  // of blade 2
  const auto last = static_cast<std::size_t>(strip.first + strip.nodes - 1);
  const ShapeNode& node = blade.nodes[static_cast<std::size_t>(blade.elements)];
  CHECK((frame.place(all, last).head<2>() - node.p).norm() < 1e-12);
  CHECK(frame.rotations[last].z() == node.angle);
  CHECK(node.angle < -1e-4);
  const std::size_t first = static_cast<std::size_t>(blade.bodies * blade.elements);
  for (std::size_t e = 0; e < blade.axial_forces.size(); ++e) {
    CHECK(frame.axial_forces[first + e] == blade.axial_forces[e]);
    CHECK(frame.bending_moments[first + e] == std::abs(blade.bending_moments[e]));
  }
  CHECK(frame.hub_angle == simulation.sensor("hub.angle"));

  REQUIRE(part.strips[0].nodes == 3);  // two elements of the model in each that is shown
  CHECK(coarse.axial_forces[0] ==
        doctest::Approx(0.5 * (frame.axial_forces[0] + frame.axial_forces[1])));
}
