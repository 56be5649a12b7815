// Rotors on supports in VTK files and scenes: where they are is what sensors and views say.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "engine/output/scene/deformed.h"
#include "engine/output/scene/make_scene.h"
#include "engine/output/vtk/spatial_vtk.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/output/vtk/vtk_numbers.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

const SimulationOptions kVtkOptions{Formulation::structured, ExecutorKind::serial, 1};

/// Machines of three kinds: on the ground, with a strut to an anchor that moves, on a fuselage.
std::vector<std::string> machine_texts() {
  const std::string strut =
      "[[support.loop]]\nname = \"strut\"\nkind = \"distance\"\n"
      "from = { body = \"nacelle\", point = [0.2, 0.3, 0.1] }\n"
      "to = { anchor = \"foot\", point = [0.2, 0.1, -0.1] }\n";
  const std::string foot =
      "[[anchor]]\nname = \"foot\"\nframe = \"mount\"\nmotion = { translation = { constant = "
      "[0.8, 1.4, -0.4], amplitude = [0.02, 0.0, 0.05], frequency = 9.0 }, rotation = { constant "
      "= [0.0, 0.2, 0.0] } }\n";
  const std::string ship =
      "[hub.mount]\ntranslation = { rate = [3.0, 0.5, 0.0] }\n"
      "rotation = { constant = [0.1, 0.0, 0.2], amplitude = [0.3, -0.2, 0.0], frequency = 4.0 }\n";
  return {make_text(kTurnedHub, kBooms + kHinges + kTower, kGravity),
          make_text(kTurnedHub + ship, kBooms + kTower + strut, kGravity + foot),
          make_text(kFuselageHub, kBooms + kHinges, kGravity)};
}

/// Without stiffening: what bending draws in is drawn of each tree, but is in no view of a marker.
Scenario machine(std::string text, double step) {
  const std::string beam = "length = 2.0\n", plain = "geometric_stiffening = false\n";
  for (std::size_t at = 0; (at = text.find(beam, at)) != std::string::npos; at += beam.size())
    at = text.insert(at, plain).find(beam, at);
  return make_scenario(text, step, 1.0);
}

/// Checks the velocities of all points against differences of their places, to `error` [m/s].
void check_drawn_velocities(const Scenario& scenario, double error) {
  Simulation simulation(scenario, kVtkOptions);
  simulation.run_until(0.05);
  SpatialVtk vtk(scenario);
  const auto before = vectors_of(vtk.make(simulation), "points");
  simulation.step();
  const auto velocities = vectors_of(vtk.make(simulation), "velocity");
  simulation.step();
  const auto after = vectors_of(vtk.make(simulation), "points");
  REQUIRE(before.size() == velocities.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < before.size(); ++k)
    largest = std::max(
        largest, (velocities[k] - (after[k] - before[k]) / (2.0 * simulation.step_size())).norm());
  CHECK(largest < error);
}

}  // namespace

TEST_CASE("a VTK file has a support's nodes, and the rotor's, where views have them") {
  for (const std::string& text : machine_texts()) {
    const Scenario scenario = machine(text, 1e-3);
    Simulation simulation(scenario, kVtkOptions);
    simulation.run_until(0.1);
    const std::string file = SpatialVtk(scenario).make(simulation);
    const std::vector<Vector> points = vectors_of(file, "points"),
                              velocities = vectors_of(file, "velocity");
    const HubFrame hub = simulation.hub_frame();
    CHECK((vectors_of(file, "hub_position")[0] - hub.position).norm() < 1e-12);
    CHECK(std::abs(simulation.sensor("hub.x") - hub.position.x()) < 1e-12);
    CHECK(std::abs(simulation.sensor("hub.z") - hub.position.z()) < 1e-12);
    std::size_t k = 0;
    for (int tree = 0; tree < 3; ++tree) {  // two blades, the support
      TreeShape shape;
      simulation.calc_shape(tree, shape);
      for (std::size_t body = 0; body < shape.bodies.size(); ++body)
        for (std::size_t node = 0; node < shape.bodies[body].nodes.size(); ++node) {
          const double last =
              std::max(1.0, static_cast<double>(shape.bodies[body].nodes.size()) - 1);
          const MarkerState marker =
              simulation.marker({tree, static_cast<int>(body), static_cast<double>(node) / last});
          CAPTURE(tree);
          CAPTURE(body);
          CHECK((points[k] - marker.position).norm() < 1e-9);
          CHECK((velocities[k] - marker.velocity).norm() < 1e-9);
          ++k;
        }
    }
    CHECK(k < points.size());
    CHECK((points[k - 1] - hub.position).norm() < 1e-9);  // the support ends at the hub
  }
}

TEST_CASE("all that is drawn of a machine moves as its velocities say") {
  for (const std::string& text : machine_texts()) check_drawn_velocities(machine(text, 1e-4), 1e-3);
}

TEST_CASE("blades of several rotors are drawn where their markers are, and move as they do") {
  Scenario scenario = read_shipped("quadcopter");
  for (spatial::Blade& blade : scenario.space->blades) blade.beam.geometric_stiffening = false;
  Simulation simulation(scenario, kVtkOptions);
  simulation.run_until(0.15);  // it rolls, and the rotors have turned by different angles
  const std::vector<Vector> points = vectors_of(SpatialVtk(scenario).make(simulation), "points");
  const scene::Scene scene = scene::make_scene(simulation, 1000);
  std::size_t blades = 0;
  for (std::size_t k = 0; k < scene.sources.size(); ++k) {
    const scene::NodeSource& source = scene.sources[k];
    if (source.subsystem == scene.support) continue;
    const MarkerState marker =
        simulation.marker({source.subsystem, source.body, source.node / 3.0});
    CHECK((points[k] - marker.position).norm() < 1e-9);
    blades += source.node == 3;
  }
  CHECK(blades == 8);
  check_drawn_velocities(scenario, 0.02);  // of a tip at 76 m/s
}

TEST_CASE("scenes of a machine show its loop closed on an anchor of the ground, from the start") {
  const Scenario scenario = machine(machine_texts()[1], 1e-3);
  const scene::Scene scene = scene::make_scene(scenario, 1000);
  REQUIRE(scene.loops.size() == 1);
  Simulation simulation(scenario, kVtkOptions);
  const scene::Frame drawn = scene::make_first_frame(scenario, scene);
  scene::Frame frame;
  scene::FrameReader reader(scene);
  reader.read(simulation, frame);
  REQUIRE(drawn.groups.size() == frame.groups.size());
  for (std::size_t g = 0; g < drawn.groups.size(); ++g) {
    CAPTURE(g);
    CHECK((drawn.groups[g].position - frame.groups[g].position).norm() < 1e-12);
    CHECK((drawn.groups[g].rotation - frame.groups[g].rotation).norm() < 1e-12);
  }
  const auto span = [&] {
    const scene::Deformed deformed(scene, frame);
    return (deformed.at(scene.loops[0].from).position - deformed.at(scene.loops[0].to).position)
        .norm();
  };
  const double length = span();
  simulation.run_until(0.1);
  reader.read(simulation, frame);
  CHECK(span() == doctest::Approx(length).epsilon(1e-6));
}
