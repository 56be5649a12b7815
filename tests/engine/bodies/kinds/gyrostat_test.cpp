// A rigid body with a spin inside moves as one that carries the wheel as a body of its own.

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSpeed = 40.0;  // of the wheel [rad/s]

/// A rigid body.
struct Part {
  double mass;
  Vector3d center;  // in the carrier's frame
  Matrix3d inertia;
};

const Part kCarrier{5.0, {0.1, 0.2, 0.05}, Vector3d(0.3, 0.4, 0.5).asDiagonal()};
const Part kWheel{1.0, {0.2, -0.1, 0.3}, Vector3d(0.02, 0.02, 0.04).asDiagonal()};

Part join(const Part& a, const Part& b) {
  Part both{a.mass + b.mass, (a.mass * a.center + b.mass * b.center) / (a.mass + b.mass),
            a.inertia + b.inertia};
  for (const Part& part : {a, b}) {
    const Vector3d r = part.center - both.center;
    both.inertia += part.mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  return both;
}

std::string to_text(const Vector3d& v) {
  std::ostringstream text;
  text.precision(17);
  text << "[" << v[0] << ", " << v[1] << ", " << v[2] << "]";
  return text.str();
}

std::string make_body(const std::string& name, const Part& part, const Vector3d& center) {
  std::ostringstream text;
  text.precision(17);
  text << "[[subsystem.body]]\nname = \"" << name << "\"\nkind = \"rigid\"\nmass = " << part.mass
       << "\ncenter = " << to_text(center) << "\ninertia = [";
  for (const auto& [row, column] : {std::pair{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}})
    text << (row + column > 0 ? ", " : "") << part.inertia(row, column);
  text << "]\n";
  return text.str();
}

const std::string kPivot = R"(
[[subsystem.joint]]
name = "pivot"
parent = "hub"
child = "carrier"
kind = "spherical"
initial_speed = [0.7, -1.2, 2.0]
)";
const std::string kMomentum = "[[sensor]]\nquantity = \"momentum\"\n";

/// The wheel on a joint that turns at its speed.
Scenario make_with_wheel(const std::string& hub, IntegrationMethod method) {
  std::ostringstream axle;
  axle << "[[subsystem.joint]]\nparent = \"carrier\"\nchild = \"wheel\"\nkind = \"revolute\"\n"
          "axis = [0, 0, 1]\noffset = "
       << to_text(kWheel.center) << "\nmotion = { time = [0.0, 10.0], value = [0.0, "
       << 10.0 * kSpeed << "] }\n";
  const std::string tree = "[[subsystem]]\nname = \"gyro\"\n" +
                           make_body("carrier", kCarrier, kCarrier.center) +
                           make_body("wheel", kWheel, Vector3d::Zero()) + kPivot + axle.str();
  return make_scenario(make_text(hub, tree, kGravity + kMomentum), 1e-3, 0.5, method);
}

/// The wheel as the spin of its carrier.
Scenario make_with_spin(const std::string& hub, IntegrationMethod method) {
  const Part both = join(kCarrier, kWheel);
  const std::string spin = "spin = " + to_text(kSpeed * kWheel.inertia.col(2)) + "\n";
  const std::string tree =
      "[[subsystem]]\nname = \"gyro\"\n" + make_body("carrier", both, both.center) + spin + kPivot;
  return make_scenario(make_text(hub, tree, kGravity + kMomentum), 1e-3, 0.5, method);
}

}  // namespace

TEST_CASE("a body with a spin moves as one that carries a wheel") {
  for (const std::string& hub : {kDrivenHub, kFlyingHub})
    for (const auto& [method, error] : {std::pair{IntegrationMethod::rk4, 1e-9},
                                        std::pair{IntegrationMethod::generalized_alpha, 1e-6}})
      for (const Formulation formulation :
           {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
        SimulationOptions options = kSerial;
        options.formulation = formulation;
        Simulation spin(make_with_spin(hub, method), options);
        Simulation wheel(make_with_wheel(hub, method), options);
        spin.run_until(0.5);
        wheel.run_until(0.5);
        const MarkerState a = spin.marker({0, 0, 0.0}), b = wheel.marker({0, 0, 0.0});
        CHECK(b.angular_velocity.norm() > 0.5);
        CHECK((a.angular_velocity - b.angular_velocity).norm() < error);
        CHECK((a.velocity - b.velocity).norm() < error);
        const Vector3d force = wheel.joint_reaction(0, 0).force;
        CHECK((spin.joint_reaction(0, 0).force - force).norm() < 10.0 * error * force.norm());
        for (const std::string component : {"x", "y", "z", "angular.x", "angular.y", "angular.z"}) {
          const double expected = wheel.sensor("momentum." + component);
          CHECK(std::abs(spin.sensor("momentum." + component) - expected) < 100.0 * error);
        }
      }
}

TEST_CASE("what spins turns the body's momentum without work") {
  Simulation simulation(make_with_spin(kFlyingHub, IntegrationMethod::rk4), kSerial);
  simulation.run_until(0.5);
  CHECK(std::abs(simulation.sensor("energy.residual")) <
        1e-9 * simulation.sensor("energy.kinetic"));
}

TEST_CASE("a body that springs hold by two hinges precesses and nutates by its spin") {
  // I1 x'' + h y' + k1 x = 0, I2 y'' - h x' + k2 y = 0.
  constexpr double kI1 = 0.3, kI2 = 0.4, kK1 = 50.0, kK2 = 20.0, kH = 1.6;
  const std::string tree = R"(
[[subsystem]]
name = "gimbal"
[[subsystem.body]]
name = "rotor"
kind = "rigid"
mass = 5.0
inertia = [0.3, 0.4, 0.5]
spin = [0.0, 0.0, 1.6]
[[subsystem.joint]]
parent = "hub"
child = "rotor"
kind = "universal"
axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
stiffness = [50.0, 20.0]
)";
  const Scenario scenario =
      make_scenario(make_text("[hub.drive]\nkind = \"fixed\"\n", tree, ""), 1e-3, 0.1);
  const ModesResult result = solve_modes(scenario, {.count = 2});
  REQUIRE(result.modes.size() == 2);
  const double half = 0.5 * (kK1 * kI2 + kK2 * kI1 + kH * kH) / (kI1 * kI2);
  const double root = std::sqrt(half * half - kK1 * kK2 / (kI1 * kI2));
  CHECK(std::abs(result.modes[0].eigenvalue.imag()) ==
        approx(std::sqrt(half - root)).epsilon(1e-8));
  CHECK(std::abs(result.modes[1].eigenvalue.imag()) ==
        approx(std::sqrt(half + root)).epsilon(1e-8));
}
