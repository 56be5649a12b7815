#include "engine/output/vtk/spatial_vtk.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/output/scene/make_scene.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/output/vtk/vtk_numbers.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1};

int count_of(const std::string& file, const std::string& what) {
  return std::atoi(file.c_str() + file.find(what + "=\"") + what.size() + 2);
}

Scenario tree_scenario(double step) {
  Scenario scenario = parse_scenario(make_text(kFlyingHub, kTree), "test");
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.step = step;
  return scenario;
}

}  // namespace

TEST_CASE("a VTK file has the nodes of all bodies first, where they are") {
  const Scenario scenario = tree_scenario(1e-3);
  Simulation simulation(scenario, kSerial);
  simulation.run_until(0.3);
  const std::string file = SpatialVtk(scenario).make(simulation);
  const std::vector<Vector> points = vectors_of(file, "points");
  const auto velocities = vectors_of(file, "velocity");
  CHECK(count_of(file, "NumberOfPoints") == static_cast<int>(points.size()));
  const HubPose hub = simulation.hub_pose();
  TreeShape shape;
  simulation.calc_shape(0, shape);
  std::size_t k = 0;
  for (const TreeBodyShape& body : shape.bodies)
    for (const TreeNode& node : body.nodes) {
      CHECK((points[k] - hub.position - hub.rotation * node.p).norm() < 1e-12);
      CHECK((velocities[k] - hub.rotation * node.velocity).norm() < 1e-12);
      ++k;
    }
  CHECK(k < points.size());
}

TEST_CASE("cells of a VTK file name points that there are, and have the forces of elements") {
  const Scenario scenario = tree_scenario(1e-3);
  Simulation simulation(scenario, kSerial);
  simulation.run_until(0.3);
  const std::string file = SpatialVtk(scenario).make(simulation);
  const double points = count_of(file, "NumberOfPoints");
  const int lines = count_of(file, "NumberOfLines"), faces = count_of(file, "NumberOfPolys");
  CHECK(lines == 4);  // two beams of two elements
  // Faces of their surfaces, a box, and three bodies of revolution of 24 sides.
  CHECK(faces == 4 * 16 + 6 + 3 * 26);
  for (const double corner : numbers_of(file.substr(file.find("<Polys>")), "connectivity")) {
    CHECK(corner >= 0.0);
    CHECK(corner < points);
  }
  const std::vector<double> ends = numbers_of(file.substr(file.find("<Polys>")), "offsets");
  CHECK(ends.size() == static_cast<std::size_t>(faces));
  const std::vector<double> axial = numbers_of(file, "axial_force");
  CHECK(axial.size() == static_cast<std::size_t>(lines + faces));
  TreeShape shape;
  simulation.calc_shape(0, shape);
  CHECK(axial[1] == shape.bodies[0].forces[1].axial);
  CHECK(numbers_of(file, "bending_moment")[0] == shape.bodies[0].forces[0].bending);
}

TEST_CASE("surfaces of a VTK file move as their velocities say") {
  const double h = 1e-4;
  const Scenario scenario = tree_scenario(h);
  Simulation simulation(scenario, kSerial);
  simulation.run_until(0.3);
  SpatialVtk vtk(scenario);
  const auto before = vectors_of(vtk.make(simulation), "points");
  simulation.step();
  const auto velocities = vectors_of(vtk.make(simulation), "velocity");
  simulation.step();
  const auto after = vectors_of(vtk.make(simulation), "points");
  REQUIRE(before.size() == velocities.size());
  for (std::size_t k = 0; k < before.size(); ++k)
    CHECK((velocities[k] - (after[k] - before[k]) / (2.0 * h)).norm() < 1e-3);
}

TEST_CASE("sections of a VTK file stand across the beam") {
  // The surface of a straight blade that is not deformed is as far from the axis as the section has
  // it.
  Scenario scenario = read_shipped("spatial_wu_haug");
  const Simulation simulation(scenario, kSerial);
  const auto points = vectors_of(SpatialVtk(scenario).make(simulation), "points");
  const scene::Scene scene = scene::make_scene(scenario, 1000000);
  const scene::Ring& ring = scene.strips[0].rings[0];
  double farthest = 0.0;
  for (std::size_t k = scene.nodes.size(); k < scene.nodes.size() + 16; ++k)
    farthest = std::max(farthest, (points[k] - ring.at.p).norm());
  CHECK(farthest == doctest::Approx(std::max(ring.half_y, ring.half_z)));
}
