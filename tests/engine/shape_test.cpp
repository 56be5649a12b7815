#include "engine/shape.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/engine/rotors.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

BladeShape shape_of(const Simulation& simulation, int blade) {
  BladeShape shape;
  simulation.calc_shape(blade, shape);
  return shape;
}

double largest_displacement(const BladeShape& shape) {
  double largest = 0.0;
  for (const ShapeNode& node : shape.nodes) largest = std::max(largest, node.displacement.norm());
  return largest;
}

/// Returns the places of the nodes of a blade in the inertial frame.
std::vector<Position> inertial_places(const Simulation& simulation, int blade) {
  const Twist hub = simulation.hub().position;
  const plane::Rotation R = plane::Rotation::from_angle(hub[kRotation]);
  std::vector<Position> places;
  for (const ShapeNode& node : shape_of(simulation, blade).nodes)
    places.emplace_back(Position{hub[0], hub[1]} + R * node.p);
  return places;
}

/// Makes blades that turn at a constant speed from the start, vibrate and come to rest in the hub
/// frame.
Scenario steady_scenario(ReferenceFrame frame) {
  Blade blade = wu_haug_blade(3, 4);
  blade.reference_frame = frame;
  Scenario scenario = spin_up_scenario(blade, 1e-3);
  scenario.rotor.hub.radius = 0.7;
  scenario.rotor.hub.drive = SpeedTable{Curve(4.0)};
  scenario.rotor.damping.stiffness_factor = 2e-3;
  scenario.integration.duration = 1.0;
  return scenario;
}

}  // namespace

TEST_CASE("a blade begins undeformed, its nodes evenly spaced along its azimuth") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, 2), 0.005);
  scenario.rotor.hub.radius = 0.5;
  const Simulation simulation(scenario, kSerial);
  const BladeShape shape = shape_of(simulation, 1);
  CHECK(shape.bodies == 4);
  CHECK(shape.elements == 2);
  REQUIRE(shape.nodes.size() == 9);
  REQUIRE(shape.axial_forces.size() == 8);
  CHECK(largest_displacement(shape) < 1e-14);
  const plane::Rotation R = plane::Rotation::from_angle(scenario.rotor.blades[1].azimuth);
  for (std::size_t k = 0; k < shape.nodes.size(); ++k) {
    const Position expected = R * Position{0.5 + 1.0 * static_cast<double>(k), 0.0};
    CHECK((shape.nodes[k].p - expected).norm() < 1e-14);
  }
  for (const double force : shape.axial_forces) CHECK(force == 0.0);
}

TEST_CASE("the last node is displaced as the tip sensors say") {
  for (const bool is_stiffened : {true, false})
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
      CAPTURE(is_stiffened);
      Blade blade = wu_haug_blade(3, 4);
      blade.geometric_stiffening = is_stiffened;
      blade.reference_frame = frame;
      Simulation simulation(spin_up_scenario(blade, 0.01), kSerial);
      simulation.run_until(6.0);
      const Position tip = shape_of(simulation, 0).nodes.back().displacement;
      CHECK(tip.x() == approx(simulation.sensor("blade1.tip.x")).epsilon(1e-9));
      CHECK(tip.y() == approx(simulation.sensor("blade1.tip.y")).epsilon(1e-9));
      CHECK(tip.y() < -0.4);
    }
}

TEST_CASE("rigid rotation displaces nothing and gives every node the velocity w x r") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.01);
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 10.0;
  SystemContext<Plane> context;
  make_context(scenario.rotor, Formulation::structured, Rk4{0.01}, context);
  const Twist hub(0.3, -0.2, 1.1);  // velocity and angular velocity, hub frame
  context.data.hub.twist = hub;
  BladeShape shape;
  calc_shape(scenario.rotor.blades[2], context.system.subsystems[2], context.data.subsystems[2],
             shape);
  CHECK(largest_displacement(shape) < 1e-14);
  for (const ShapeNode& node : shape.nodes) {
    const Position expected =
        Position(hub.head<kPosition>()) + hub[kRotation] * quarter_turn(node.p);
    CHECK((node.velocity - expected).norm() < 1e-13);
  }
}

TEST_CASE("adjoining bodies share the point of their joint in any state") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 10; ++trial) {
    const Rotor rotor = make_random_rotor({3, HubSupport::free, false}, random);
    SystemContext<Plane> context;
    make_context(rotor, Formulation::structured, Rk4{0.01}, context);
    randomize_state(random, context);
    for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
      const Blade& blade = rotor.blades[i];
      SubsystemData<Plane>& data = context.data.subsystems[i];
      BladeShape shape;
      calc_shape(blade, context.system.subsystems[i], data, shape);
      Position shortened = Position::Zero();
      for (int j = 0; j < blade.bodies; ++j) {
        const Position joint = data.poses[j].p - shortened;
        CHECK((shape.nodes[j * blade.elements].p - joint).norm() < 1e-13);
        shortened += data.poses[j].R * Position{plane::calc_foreshortening(data.bodies[j]), 0.0};
      }
      const Twist tip = calc_tip_displacement(context.system.subsystems[i], data);
      CHECK((shape.nodes.back().displacement - tip.head<kPosition>()).norm() < 1e-12);
    }
  }
}

TEST_CASE("velocities are the rates of the places") {
  for (const bool is_stiffened : {true, false}) {
    CAPTURE(is_stiffened);
    Blade blade = wu_haug_blade(2, 3);
    blade.geometric_stiffening = is_stiffened;
    Scenario scenario = spin_up_scenario(blade, 1e-3);
    scenario.integration.tolerance = 1e-14;
    Simulation simulation(scenario, kSerial);
    simulation.run_until(5.0);
    const auto before = inertial_places(simulation, 1);
    simulation.step();
    const BladeShape shape = shape_of(simulation, 1);
    const plane::Rotation R = plane::Rotation::from_angle(simulation.hub().position[kRotation]);
    simulation.step();
    const auto after = inertial_places(simulation, 1);
    for (std::size_t k = 0; k < shape.nodes.size(); ++k) {
      const Position rate = (after[k] - before[k]) / 2e-3;
      CHECK((R * shape.nodes[k].velocity - rate).norm() < 1e-5);
    }
    CHECK(shape.nodes.back().velocity.norm() > 6.0);
  }
}

TEST_CASE("a steadily turning blade pulls on its elements with the centrifugal force outboard") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const Scenario scenario = steady_scenario(frame);
    Simulation simulation(scenario, kSerial);
    simulation.run_until(1.0);
    const BladeShape shape = shape_of(simulation, 2);
    const Blade& blade = scenario.rotor.blades[2];
    const double rhoA = blade.density * blade.area;
    const double L = scenario.rotor.hub.radius + blade.length;
    const double l = blade.length / 12.0;
    for (std::size_t e = 0; e < shape.axial_forces.size(); ++e) {
      const double a = scenario.rotor.hub.radius + l * static_cast<double>(e), b = a + l;
      // The mean over the element of N(r) = rhoA w^2 (L^2 - r^2)/2, r from the hub's axis.
      const double mean = rhoA * 16.0 / 2.0 * (L * L - (a * a + a * b + b * b) / 3.0);
      CAPTURE(e);
      CHECK(shape.axial_forces[e] == approx(mean).epsilon(2e-4));
    }
  }
}
