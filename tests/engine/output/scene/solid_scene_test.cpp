// Solids of simulations on pages, in VTK files and in sensors.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/output/scene/deformed.h"
#include "engine/output/scene/make_scene.h"
#include "engine/output/vtk/solid_vtk.h"
#include "engine/simulation.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

const SimulationOptions kOne{Formulation::structured, ExecutorKind::serial, 1};

/// Takes the stiffening off all solids: drawn nodes then need no correction of second order.
spatial::Model without_stiffening(spatial::Model model) {
  for (spatial::Subsystem& subsystem : model.subsystems)
    for (spatial::Body& body : subsystem.bodies)
      if (auto* solid = std::get_if<spatial::SolidBody>(&body.shape))
        solid->geometric_stiffening = false;
  return model;
}

Scenario make_scenario(const spatial::Model& model, double step = 5e-4) {
  Scenario scenario;
  scenario.space = model;
  scenario.integration.step = step;
  scenario.integration.duration = 100 * step;
  return scenario;
}

Scenario moving_trees() {
  return make_scenario(without_stiffening(make_solid_trees(HubSupport::free)));
}

/// A bar without Poisson's effect, at rest on a hub, in equilibrium with loads on its tip. Its
/// section is 0.1 m wide and high.
Scenario held_bar(const Vector& force, const Vector& moment) {
  spatial::Model model;
  model.hub.drive = FixedDrive{};
  spatial::SolidBody bar = make_bar(slender_grid(), {2e11, 0.0, 7800.0});
  bar.geometric_stiffening = false;
  spatial::SubsystemJoint joint;
  joint.child = "bar";
  spatial::Subsystem arm;
  arm.name = "arm";
  arm.bodies = {{"bar", bar}};
  arm.joints = {joint};
  model.subsystems = {arm};
  spatial::PointLoad load;
  load.place = {BladeChoice::all(), "arm", "bar"};
  load.interface = "tip";
  load.force = force;
  load.moment = moment;
  model.loads = {load};
  Scenario scenario = make_scenario(model, 1e-5);
  scenario.initial.state = InitialState::equilibrium;
  return scenario;
}

Sensor make_sensor(SensorQuantity quantity, const std::string& name, const std::string& body,
                   const std::string& interface = {}) {
  Sensor sensor;
  sensor.quantity = quantity;
  sensor.name = name;
  sensor.subsystem = "tree";
  sensor.body = body;
  sensor.interface = interface;
  sensor.frame =
      quantity == SensorQuantity::von_mises ? std::nullopt : std::optional(SensorFrame::inertial);
  return sensor;
}

/// Returns the place of a node in the hub's frame by the constants and coordinates of its solid.
Vector place_directly(const TreeBodyShape& shape, int node) {
  const Eigen::VectorXd u = calc_displacements(*shape.solid, shape.coordinates.data());
  const TreeNode& frame = shape.nodes.front();
  return frame.p +
         frame.R * (shape.solid->nodes[static_cast<std::size_t>(node)] + u.segment<3>(3 * node));
}

/// Returns the numbers of an array of a file.
std::vector<double> read_numbers(const std::string& file, const std::string& name) {
  const std::size_t at = file.find("Name=\"" + name + "\"");
  REQUIRE(at != std::string::npos);
  const char* text = file.c_str() + file.find('\n', at);
  std::vector<double> numbers;
  for (char* end = nullptr;; text = end) {
    const double number = std::strtod(text, &end);
    if (end == text) return numbers;
    numbers.push_back(number);
  }
}

Vector at_point(const std::vector<double>& numbers, std::size_t k) {
  return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
}

}  // namespace

TEST_CASE("drawn nodes of solids are where constants and coordinates have them") {
  for (const auto coordinates :
       {spatial::SolidCoordinates::reduced, spatial::SolidCoordinates::nodal}) {
    spatial::Model model = without_stiffening(make_solid_trees(HubSupport::axle, coordinates));
    Simulation simulation(make_scenario(model), kOne);
    simulation.run_until(10 * simulation.step_size());
    const scene::Scene scene = scene::make_scene(simulation, 2000);
    REQUIRE(scene.meshes.size() == 4);
    scene::FrameReader reader(scene);
    scene::Frame frame;
    reader.read(simulation, frame);
    const scene::Deformed deformed(scene, frame);
    double moved = 0.0;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      const scene::MeshBody& mesh = scene.meshes[m];
      const auto& surface = scene.surfaces[static_cast<std::size_t>(mesh.surface)];
      const TreeBodyShape& shape =
          reader.body_of(scene.sources[static_cast<std::size_t>(mesh.node)]);
      REQUIRE(!surface.nodes.empty());
      for (std::size_t k = 0; k < surface.nodes.size(); k += 5) {
        const Vector found = place_of(scene, frame, deformed, m, k);
        CHECK((found - place_directly(shape, surface.nodes[k])).norm() < 1e-12);
        moved = std::max(moved, displacement_of(scene, frame, deformed, m, k).norm());
      }
      for (std::size_t i = 0; i < mesh.interfaces.size(); ++i)
        CHECK((deformed.node(mesh.interfaces[i].node).position - shape.nodes[1 + i].p).norm() <
              1e-12);
    }
    CHECK(moved > 1e-4);
  }
}

TEST_CASE("equal solids share a surface, and a scene without constants has them at rest") {
  const Scenario scenario = make_scenario(make_solid_trees(HubSupport::axle));
  const Simulation simulation(scenario, kOne);
  const scene::Scene scene = scene::make_scene(simulation, 2000);
  REQUIRE(scene.meshes.size() == 4);
  CHECK(scene.surfaces.size() == 3);
  CHECK(scene.meshes[0].name == "tree / arm");
  CHECK(scene.meshes[3].surface == scene.meshes[0].surface);
  REQUIRE(scene.meshes[0].interfaces.size() == 3);
  CHECK(scene.meshes[0].interfaces[2].name == "side");
  const scene::Scene at_rest = scene::make_scene(scenario, 2000);
  CHECK(!at_rest.surfaces[0].recovery);
  CHECK(at_rest.surfaces[0].places.size() == scene.surfaces[0].places.size());
  // The arm's root is 0.3 m from the hub; its tip is 1 m further.
  CHECK((at_rest.nodes[static_cast<std::size_t>(scene.meshes[0].interfaces[1].node)].p -
         Vector(1.3, 0.0, 0.0))
            .norm() < 1e-12);
}

TEST_CASE("a VTK file of solids has their nodes and elements, which move by their velocities") {
  const Scenario scenario =
      make_scenario(without_stiffening(make_solid_trees(HubSupport::free)), 1e-4);
  Simulation simulation(scenario, kOne);
  SolidVtk vtk(simulation);
  REQUIRE(vtk.are_there());
  simulation.run_until(20 * simulation.step_size());
  const auto before = read_numbers(vtk.make(simulation), "points");
  simulation.step();
  const std::string file = vtk.make(simulation);
  TreeShape shape;
  simulation.calc_shape(0, shape);
  const HubPose hub = simulation.hub_pose();
  simulation.step();
  const auto after = read_numbers(vtk.make(simulation), "points");
  const auto points = read_numbers(file, "points"), velocities = read_numbers(file, "velocity");
  const std::size_t nodes = shape.bodies[0].solid->nodes.size();
  REQUIRE(points.size() == 4 * 3 * nodes);
  for (std::size_t k = 0; k < 4 * nodes; ++k) {
    const Vector rate = (at_point(after, k) - at_point(before, k)) / 2e-4;
    CHECK((at_point(velocities, k) - rate).norm() < 2e-3);
  }
  for (std::size_t k = 0; k < nodes; ++k)
    CHECK((at_point(points, k) - hub.position -
           hub.rotation * place_directly(shape.bodies[0], static_cast<int>(k)))
              .norm() < 1e-12);
  // Four bars of 4 x 6 quadratic tetrahedra.
  const std::vector<double> types = read_numbers(file, "types"),
                            ends = read_numbers(file, "offsets"),
                            corners = read_numbers(file, "connectivity");
  CHECK(types == std::vector<double>(4 * 24, 24.0));
  CHECK(ends.back() == 4.0 * 24.0 * 10.0);
  CHECK(corners.size() == static_cast<std::size_t>(ends.back()));
  CHECK(*std::max_element(corners.begin(), corners.end()) == static_cast<double>(4 * nodes - 1));
  // Each mid node stands in the middle of its edge, as VTK wants it, but for the deformation.
  constexpr int kEnds[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (std::size_t e = 0; e < 6; ++e) {
    const auto corner = [&](int c) {
      return at_point(points, static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]));
    };
    const Vector middle = 0.5 * (corner(kEnds[e][0]) + corner(kEnds[e][1]));
    CHECK((corner(4 + static_cast<int>(e)) - middle).norm() < 0.01);
  }
  CHECK(read_numbers(file, "von_mises").size() == 4 * nodes);
}

TEST_CASE("a bar at rest has the von Mises stress of its loads") {
  const double area = 0.01, I = 1e-4 / 12.0;
  Scenario scenario = held_bar({5e4, 0.0, 0.0}, Vector::Zero());
  Sensor largest = make_sensor(SensorQuantity::von_mises, "stress", "bar");
  largest.subsystem = "arm";
  Sensor node = largest;
  node.name = "node";
  node.node = 5;
  Sensor root = largest;
  root.name = "root";
  root.interface = "root";
  scenario.sensors = {largest, node, root};
  const Simulation pulled(scenario, kOne);
  CHECK(pulled.sensor("arm.stress") == doctest::Approx(5e4 / area).epsilon(1e-6));
  CHECK(pulled.sensor("arm.node") == doctest::Approx(5e4 / area).epsilon(1e-6));
  CHECK(pulled.sensor("arm.root") == doctest::Approx(5e4 / area).epsilon(1e-6));
  scenario.space->loads[0].force = Vector::Zero();
  scenario.space->loads[0].moment = Vector(0.0, 300.0, 0.0);
  const Simulation bent(scenario, kOne);
  CHECK(bent.sensor("arm.stress") == doctest::Approx(300.0 * 0.05 / I).epsilon(1e-6));
  // The equilibrium has the same deformation, and the page's nodes that stress.
  const EquilibriumResult result = solve_equilibrium(scenario);
  REQUIRE(result.blades[0].solids.size() == 1);
  const SolidDeformation& solid = result.blades[0].solids[0];
  const space::NodeRecovery recovery(*solid.solid);
  CHECK(recovery.largest_von_mises(solid.coordinates.data()).value ==
        doctest::Approx(300.0 * 0.05 / I).epsilon(1e-6));
}

TEST_CASE("a node at the point of a rigid interface moves as the interface does") {
  Scenario scenario = moving_trees();
  const auto mesh = make_grid_mesh(slender_grid());
  int label = 0;
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
    if ((mesh.nodes[k] - Vector(1.0, 0.0, 0.0)).norm() < 1e-12) label = static_cast<int>(k) + 1;
  REQUIRE(label > 0);
  if (!mesh.labels.empty()) label = mesh.labels[static_cast<std::size_t>(label) - 1];
  const SensorQuantity motions[] = {SensorQuantity::displacement, SensorQuantity::velocity,
                                    SensorQuantity::acceleration};
  for (const SensorQuantity quantity : motions) {
    const std::string name(name_of(quantity));
    Sensor node = make_sensor(quantity, name + "_node", "arm");
    node.node = label;
    scenario.sensors.push_back(make_sensor(quantity, name, "arm", "tip"));
    scenario.sensors.push_back(node);
  }
  Simulation simulation(scenario, kOne);
  simulation.run_until(20 * simulation.step_size());
  for (const SensorQuantity quantity : motions) {
    const std::string name = "tree." + std::string(name_of(quantity));
    const Vector of_interface = vector_of(simulation, name);
    CHECK(of_interface.norm() > 1e-3);
    CHECK((vector_of(simulation, name + "_node") - of_interface).norm() <
          1e-9 * of_interface.norm());
  }
}

TEST_CASE("the force on an interface is that of the joints, loads and loops there") {
  Scenario scenario = moving_trees();
  spatial::PointLoad load;
  load.place = {BladeChoice::all(), "tree", "arm"};
  load.interface = "tip";
  load.frame = spatial::LoadFrame::inertial;
  load.force = Vector(0.4, -0.3, 0.8);
  scenario.space->loads = {load};
  scenario.sensors = {make_sensor(SensorQuantity::interface_force, "held", "arm", "root"),
                      make_sensor(SensorQuantity::interface_force, "tip", "arm", "tip"),
                      make_sensor(SensorQuantity::joint_reaction, "hinge", "arm"),
                      make_sensor(SensorQuantity::joint_reaction, "ball", "outer")};
  Simulation simulation(scenario, kOne);
  simulation.run_until(20 * simulation.step_size());
  const auto force = [&](const std::string& name) {
    return vector_of(simulation, "tree." + name + ".force");
  };
  const auto moment = [&](const std::string& name) {
    return vector_of(simulation, "tree." + name + ".moment");
  };
  CHECK((force("held") - force("hinge")).norm() < 1e-12);
  CHECK((moment("held") - moment("hinge")).norm() < 1e-12);
  CHECK(force("ball").norm() > 0.1);
  CHECK((force("tip") + force("ball") - load.force).norm() < 1e-9);
  // The joint is 20 mm outboard of the interface's point.
  TreeShape shape;
  simulation.calc_shape(0, shape);
  const Vector arm =
      simulation.hub_pose().rotation * (shape.bodies[0].nodes[2].R * Vector(0.02, 0.0, 0.0));
  CHECK((moment("tip") + moment("ball") + arm.cross(force("ball"))).norm() < 1e-9);
}

TEST_CASE("modes hold the motions of solids' coordinates") {
  Scenario scenario = held_bar(Vector::Zero(), Vector::Zero());
  scenario.initial.state = InitialState::undeformed;
  ModeOptions options;
  options.count = 3;
  const ModesResult result = solve_modes(scenario, options);
  for (const Mode& mode : result.modes) {
    REQUIRE(mode.solids.size() == 1);
    REQUIRE(mode.solids[0].size() == 1);
    // Coordinates of a bar that nothing else holds are its modes: one moves alone, or two of equal
    // frequencies.
    Eigen::VectorXd size = mode.solids[0][0].cwiseAbs();
    std::sort(size.begin(), size.end(), std::greater<>());
    CHECK(size.head(2).norm() == doctest::Approx(size.norm()).epsilon(1e-6));
    const SolidDeformation& solid = result.equilibrium.blades[0].solids[0];
    CHECK(solid.solid->coordinates == size.size());
  }
}
