#include "engine/tree_shape.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/output/scene/make_scene.h"
#include "engine/simulation.h"
#include "models/space/rotation_vector.h"
#include "models/tree/tree.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/serial.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Tensor;
using spatial::Vector;

namespace {

Scenario space_scenario(const std::string& hub, const std::string& bodies, double step) {
  Scenario scenario = parse_scenario(make_text(hub, bodies, kGravity), "test");
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.step = step;
  return scenario;
}

TreeShape shape_of(const Simulation& simulation, int tree) {
  TreeShape shape;
  simulation.calc_shape(tree, shape);
  return shape;
}

/// Returns places and rotations of nodes in the inertial frame.
std::vector<spatial::Placement> inertial_places(const Simulation& simulation, int tree) {
  const HubPose hub = simulation.hub_pose();
  std::vector<spatial::Placement> places;
  for (const TreeBodyShape& body : shape_of(simulation, tree).bodies)
    for (const TreeNode& node : body.nodes)
      places.push_back({hub.position + hub.rotation * node.p, hub.rotation * node.R});
  return places;
}

/// Velocity and angular velocity by two placements, `span` [s] apart.
struct Rates {
  Vector velocity, angular_velocity;
};
Rates rates_between(const spatial::Placement& a, const spatial::Placement& b, double span) {
  const Eigen::AngleAxisd turn(Tensor(b.rotation * a.rotation.transpose()));
  return {(b.position - a.position) / span, turn.angle() * turn.axis() / span};
}

}  // namespace

TEST_CASE("the last node of a tree is where the tip's sensors have it") {
  for (const auto& [hub, bodies] :
       {std::pair{kTurnedHub, kBooms + kHinges}, std::pair{kDrivenHub, kBooms + kHinges + kPitch},
        std::pair{kFlyingHub, kTree}, std::pair{kTurnedHub, kForest}}) {
    const Scenario scenario = space_scenario(hub, bodies, 1e-3);
    const scene::Scene scene = scene::make_scene(scenario, 1000);
    const Tensor axes = rotor_placement(scenario.space->hub).rotation;
    Simulation simulation(scenario, kSerial);
    simulation.run_until(0.5);
    for (int i = 0; i < static_cast<int>(scene.subsystems.size()); ++i) {
      std::string name = scene.subsystems[static_cast<std::size_t>(i)] + ".tip.";
      std::erase(name, ' ');
      const Vector sensor(simulation.sensor(name + 'x'), simulation.sensor(name + 'y'),
                          simulation.sensor(name + 'z'));
      const TreeShape shape = shape_of(simulation, i);
      const auto tip = static_cast<std::size_t>(scene.tips[static_cast<std::size_t>(i)]);
      const Vector moved = shape.bodies.back().nodes.back().p - scene.nodes[tip].p;
      CAPTURE(name);
      CHECK(sensor.norm() > 1e-3);
      CHECK((moved - axes * sensor).norm() < 1e-12);
    }
  }
}

TEST_CASE("velocities of nodes are the rates of their places") {
  for (const auto& [hub, bodies] :
       {std::pair{kTurnedHub, kBooms + kHinges}, std::pair{kFlyingHub, kTree},
        std::pair{kFlyingHub, kMotors}, std::pair{kFlyingHub, kForest},
        std::pair{kDrivenHub, kBooms + kPitch}}) {
    const double h = 1e-4;
    Simulation simulation(space_scenario(hub, bodies, h), kSerial);
    simulation.run_until(0.3);
    const auto before = inertial_places(simulation, 0);
    simulation.step();
    const Tensor R = simulation.hub_pose().rotation;
    const TreeShape shape = shape_of(simulation, 0);
    simulation.step();
    const auto after = inertial_places(simulation, 0);
    std::size_t k = 0;
    double fastest = 0.0;
    for (const TreeBodyShape& body : shape.bodies)
      for (const TreeNode& node : body.nodes) {
        const Rates rates = rates_between(before[k], after[k], 2.0 * h);
        ++k;
        fastest = std::max(fastest, node.velocity.norm());
        CHECK((R * node.velocity - rates.velocity).norm() < 1e-3);
        CHECK((R * node.angular_velocity - rates.angular_velocity).norm() < 1e-2);
      }
    CHECK(fastest > 0.5);
  }
}

TEST_CASE("a planar rotor in space has the shape and the forces that it has in the plane") {
  Simulation plane(read_shipped("wu_haug_rotor"), kSerial),
      space(read_shipped("spatial_wu_haug"), kSerial);
  plane.run_until(3.0);
  space.run_until(3.0);
  BladeShape blade;
  plane.calc_shape(1, blade);
  const TreeShape tree = shape_of(space, 1);
  REQUIRE(tree.bodies.size() == static_cast<std::size_t>(blade.bodies));
  double largest = 0.0, tension = 0.0, bending = 0.0;
  for (std::size_t j = 0; j < tree.bodies.size(); ++j)
    for (std::size_t k = 0; k < tree.bodies[j].nodes.size(); ++k) {
      const std::size_t at = j * static_cast<std::size_t>(blade.elements) + k;
      const TreeNode& node = tree.bodies[j].nodes[k];
      const ShapeNode& planar = blade.nodes[at];
      largest = std::max(largest, planar.displacement.norm());
      CHECK((node.p.head<2>() - planar.p).norm() < 1e-7);
      CHECK((node.displacement.head<2>() - planar.displacement).norm() < 1e-7);
      CHECK((node.velocity.head<2>() - planar.velocity).norm() < 1e-6);
      CHECK(std::abs(node.rotation.z() - planar.angle) < 1e-7);
      if (k + 1 == tree.bodies[j].nodes.size()) continue;
      const ElementForces& forces = tree.bodies[j].forces[k];
      tension = std::max(tension, forces.axial);
      bending = std::max(bending, forces.bending);
      CHECK(forces.axial == doctest::Approx(blade.axial_forces[at]).epsilon(1e-5));
      CHECK(forces.bending ==
            doctest::Approx(std::abs(blade.bending_moments[at])).epsilon(1e-4).scale(1.0));
      CHECK(std::abs(forces.torsion) < 1e-9);
    }
  CHECK(largest > 0.01);
  CHECK(tension > 0.1);
  CHECK(bending > 1.0);
}

TEST_CASE("a beam that stands undeformed moves with its joints alone") {
  // The initial angles of the joints are no deformation.
  for (const std::string& bodies : {kTree, kForest, kMotors, kBooms + kHinges}) {
    const Simulation simulation(space_scenario(kFlyingHub, bodies, 1e-3), kSerial);
    for (const TreeBodyShape& body : shape_of(simulation, 0).bodies)
      for (const TreeNode& node : body.nodes) {
        CHECK(node.displacement.norm() < 1e-14);
        CHECK(node.rotation.norm() < 1e-14);
      }
  }
}

TEST_CASE("the hub's frame is the inertial one at the start, and turns about the hub's axis") {
  Simulation simulation(space_scenario(kDrivenHub, kBooms, 1e-3), kSerial);
  CHECK((simulation.hub_pose().rotation - Tensor::Identity()).norm() < 1e-15);
  simulation.run_until(0.7);
  const double angle = simulation.sensor("hub.angle");
  CHECK(angle > 1.0);
  const Vector axis = Vector(0.2, 0.3, 1.0).normalized();
  const Tensor expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  CHECK((simulation.hub_pose().rotation - expected).norm() < 1e-12);

  Simulation plane(read_shipped("wu_haug_rotor"), kSerial);
  plane.run_until(3.0);
  const Tensor turned =
      Eigen::AngleAxisd(plane.sensor("hub.angle"), Vector::UnitZ()).toRotationMatrix();
  CHECK((plane.hub_pose().rotation - turned).norm() < 1e-12);
}

TEST_CASE("shapes of trees that do not exist are refused") {
  const Simulation space(space_scenario(kDrivenHub, kBooms, 1e-3), kSerial);
  CHECK(message_of([&] { shape_of(space, 2); }) == "the index of the tree is 2, expected 0 to 1");
  CHECK(message_of([&] { shape_of(space, -1); }) == "the index of the tree is -1, expected 0 to 1");
  const Simulation plane(read_shipped("wu_haug_rotor"), kSerial);
  CHECK(message_of([&] { shape_of(plane, 0); }) ==
        "the shape of a tree: the model is in the plane, expected one in space");
}
