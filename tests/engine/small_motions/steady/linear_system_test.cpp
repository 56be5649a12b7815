// Compares the linear system with the nonlinear one under small inputs.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "tests/engine/small_motions/steady/blades.h"

namespace spoke {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::make_planar;
using test::make_spatial;

constexpr double kStep = 1e-3;   ///< [s]
constexpr double kSmall = 1e-4;  ///< amplitude of the input
constexpr double kDuration = 0.3;

Eigen::Index find(const std::vector<LinearSignal>& signals, const std::string& name) {
  const auto at = std::find_if(signals.begin(), signals.end(),
                               [&](const LinearSignal& signal) { return signal.name == name; });
  CAPTURE(name);
  REQUIRE(at != signals.end());
  return at - signals.begin();
}

/// The course of the input: it rises, and is not smooth to high order.
const Curve kInput({0.0, 0.1, 0.2}, {0.0, kSmall, -kSmall});

/// Returns outputs over time by the trapezoidal rule, which generalized_alpha is at a radius of 1.
MatrixXd simulate_linear(const LinearSystem& system, const std::string& input) {
  const Eigen::Index n = system.A.rows(), k = find(system.inputs, input);
  const int steps = static_cast<int>(std::round(kDuration / kStep));
  const MatrixXd one = MatrixXd::Identity(n, n), A = 0.5 * kStep * MatrixXd(system.A);
  const Eigen::PartialPivLU<MatrixXd> implicit(one - A);
  const VectorXd b = MatrixXd(system.B).col(k), d = MatrixXd(system.D).col(k);
  VectorXd x = VectorXd::Zero(n);
  MatrixXd outputs(system.C.rows(), steps + 1);
  outputs.col(0) = d * kInput.value(0.0);
  for (int step = 1; step <= steps; ++step) {
    const double before = kInput.value((step - 1) * kStep), now = kInput.value(step * kStep);
    x = implicit.solve(x + A * x + 0.5 * kStep * (before + now) * b);
    outputs.col(step) = system.C * x + d * now;
  }
  return outputs;
}

/// An output, and the sensor of the simulation that shows the same.
struct Shown {
  std::string output, sensor;
};

/// Returns sensors over time, as differences from their start.
MatrixXd simulate(Scenario scenario, const std::vector<Shown>& shown) {
  scenario.integration.duration = kDuration;
  scenario.integration.step = kStep;
  scenario.integration.spectral_radius = 1.0;
  scenario.integration.tolerance = 1e-14;
  Simulation simulation(scenario);
  MatrixXd outputs(std::ssize(shown), simulation.planned_steps() + 1);
  const auto take = [&](Eigen::Index step) {
    for (std::size_t k = 0; k < shown.size(); ++k)
      outputs(static_cast<Eigen::Index>(k), step) = simulation.sensor(shown[k].sensor);
  };
  take(0);
  while (!simulation.done()) {
    simulation.step();
    take(simulation.steps());
  }
  return outputs.colwise() - VectorXd(outputs.col(0));
}

/// Checks that both simulations agree in all outputs that are shown, to `error` of the largest
/// value of each.
void compare(const LinearSystem& system, const std::string& input, const Scenario& scenario,
             const std::vector<Shown>& shown, double error) {
  const MatrixXd linear = simulate_linear(system, input), known = simulate(scenario, shown);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    CAPTURE(shown[k].sensor);
    const auto row = static_cast<Eigen::Index>(k);
    const double size = known.row(row).lpNorm<Eigen::Infinity>();
    CHECK(size > 0.0);
    const VectorXd difference = linear.row(find(system.outputs, shown[k].output)) - known.row(row);
    CHECK(difference.lpNorm<Eigen::Infinity>() < error * size);
  }
}

const std::string kSensors =
    "[[sensor]]\nname = \"a\"\nquantity = \"acceleration\"\n[[sensor]]\nname = \"f\"\n"
    "quantity = \"section_force\"\nposition = 0.3\n[[sensor]]\nname = \"i\"\n"
    "quantity = \"displacement\"\nframe = \"inertial\"\n";
const std::string kSteady =
    "[damping]\nstiffness_factor = 2e-3\n[initial]\nstate = \"equilibrium\"\n";

/// Returns the steady value `base` plus the input.
Curve about(double base) {
  std::vector<double> values = kInput.values();
  for (double& value : values) value += base;
  return Curve(kInput.times(), values);
}

TEST_CASE("linear system: a bent blade of the plane at speed answers a load likewise") {
  Scenario scenario = make_planar({.bodies = 2,
                                   .elements = 2,
                                   .radius = 0.2,
                                   .axial_stiffness = 1e4,
                                   .more = "[[load]]\nforce = [0.0, 0.5]\n" + kSensors + kSteady});
  scenario.rotor.hub.drive = ConstantSpeed{3.0};
  const LinearSystem system = solve_linear_system(scenario);
  CHECK(system.states.size() == 2 * 12);
  CHECK(system.states[0].name == "blade 1 / body 1 / node 1 / u");
  CHECK(system.states[12].unit == "m/s");
  CHECK(system.inputs.size() == 1);
  CHECK(system.left_out.size() == 3);
  scenario.rotor.loads[0].factor = about(1.0);
  compare(system, "blade 1 / load.1", scenario,
          {{"blade1.tip.y", "blade1.tip.y"},
           {"blade1.a.y", "blade1.a.y"},
           {"blade1.f.moment", "blade1.f.moment"}},
          2e-3);
}

TEST_CASE("linear system: a hinged blade in space and its hub answer torque, motor and load") {
  const std::string hinge =
      "[[blades.joint]]\nname = \"flap\"\nstation = 0.0\nkind = \"revolute\"\n"
      "axis = [0.0, -1.0, 0.0]\n";
  Scenario scenario = make_spatial(
      {.bodies = 1,
       .elements = 3,
       .radius = 0.1,
       .axial_stiffness = 1e4,
       .joint = hinge,
       .more = "[[load]]\nframe = \"hub\"\nforce = [0.0, 0.0, 1.0]\n" + kSensors + kSteady});
  scenario.space->hub.drive = TorqueDrive{Curve(0.0), 0.0};
  scenario.initial.speed = 4.0;
  const LinearSystem system = solve_linear_system(scenario, {.speed = 4.0});
  CHECK(system.states[0].name == "hub / angle");
  CHECK(system.inputs.back().name == "hub / torque");
  CHECK(system.inputs.back().unit == "N m");
  const std::vector<Shown> shown{{"blade1.tip.z", "blade1.tip.z"},
                                 {"rate of hub / angle", "hub.speed"},
                                 {"blade 1 / flap", "blade1.flap"},
                                 {"blade1.a.y", "blade1.a.y"},
                                 {"blade1.f.moment.y", "blade1.f.moment.y"}};
  Scenario driven = scenario;
  std::get<TorqueDrive>(driven.space->hub.drive).torque = about(0.0);
  compare(system, "hub / torque", driven, shown, 5e-3);
  Scenario motor = scenario;
  motor.space->blades[0].joints[0].joint.coordinates[0].effort = about(0.0);
  compare(system, "blade 1 / flap motor", motor, shown, 5e-3);
  Scenario loaded = scenario;
  loaded.space->loads[0].factor = about(1.0);
  compare(system, "blade 1 / load.1", loaded, shown, 5e-3);
}

TEST_CASE("linear system: its eigenvalues are those of the modes") {
  Scenario scenario = make_planar({.bodies = 1, .elements = 2, .axial_stiffness = 1e4});
  const LinearSystem system = solve_linear_system(scenario, {.speed = 2.0});
  const ModesResult modes = solve_modes(scenario, {.state = {.speed = 2.0}, .count = 2});
  const Eigen::VectorXcd roots = MatrixXd(system.A).eigenvalues();
  for (const Mode& mode : modes.modes)
    CHECK((roots.array() - mode.eigenvalue).abs().minCoeff() < 1e-6 * mode.frequency);
}

}  // namespace
}  // namespace spoke
