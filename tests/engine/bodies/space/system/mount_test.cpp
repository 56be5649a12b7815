// A mount that moves the hub's axle: against the same motion described otherwise, against closed
// forms, and its work in the balance of energies.

#include "models/space/mount.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "models/space/rotation_vector.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kDuration = 0.4;

/// A ship in waves that goes ahead and turns.
const std::string kShip = R"(
[hub.mount]
translation = { rate = [3.0, 0.5, 0.0], amplitude = [0.2, 0.1, 0.4], frequency = 5.0, phase = 0.3 }
rotation = { constant = [0.1, 0.0, 0.2], rate = [0.0, 0.0, 0.5], amplitude = [0.3, -0.2, 0.0], frequency = 4.0 }
)";

Simulation make_simulation(const std::string& hub, const std::string& bodies,
                           IntegrationMethod method, double step,
                           Formulation formulation = Formulation::structured,
                           const std::string& more = kGravity) {
  Scenario scenario = parse_scenario(make_text(hub, bodies, more), "test.toml");
  scenario.integration.method = method;
  scenario.integration.step = step;
  scenario.integration.tolerance =
      1e-12;  // formulations differ in when they take one iteration more
  scenario.integration.duration = kDuration;
  scenario.limits.deflection = 0.0;
  return Simulation(scenario, {formulation, ExecutorKind::serial, 1, 0});
}

double largest_difference(const Simulation& a, const Simulation& b, const std::string& what) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.sensor_names().size(); ++k)
    if (a.sensor_names()[k].find(what) != std::string::npos)
      largest = std::max(largest, std::abs(a.sensor_values()[k] - b.sensor_values()[k]));
  return largest;
}

}  // namespace

TEST_CASE("the motion of a mount is that of its differences") {
  space::Hub hub;
  hub.orientation = space::make_quaternion(space::Angular(0.3, -0.2, 0.5));
  spatial::VectorTable table;
  table.components[1] = Curve({0.0, 1.0, 2.0}, {0.0, 0.4, 0.1});
  hub.mount = spatial::MountMotion{
      table, spatial::VectorHarmonic{{0.1, 0.0, 0.4}, {0.0, 0.6, -0.3}, {0.5, 0.2, 0.9}, 2.0, 0.3}};
  constexpr double h = 1e-5, t = 0.7;
  const space::AxleMotion now = calc_axle_motion(hub, t), before = calc_axle_motion(hub, t - h),
                          after = calc_axle_motion(hub, t + h);
  const auto close = [](const auto& a, const auto& b) { return (a - b).norm() < 1e-8; };
  CHECK(close(now.v, space::Position((after.p - before.p) / (2.0 * h))));
  CHECK(close(now.a, space::Position((after.v - before.v) / (2.0 * h))));
  CHECK(close(now.w, space::Angular(logarithm(before.R.inverse() * after.R) / (2.0 * h))));
  CHECK(close(now.alpha, space::Angular((after.w - before.w) / (2.0 * h))));
}

TEST_CASE("a mount at constant speed deforms nothing") {
  const std::string flight = kDrivenHub + "[hub.mount]\ntranslation = { rate = [30, 0, 10] }\n";
  for (const Formulation formulation : {Formulation::structured, Formulation::augmented}) {
    Simulation still = make_simulation(kDrivenHub, kBooms + kHinges,
                                       IntegrationMethod::generalized_alpha, 5e-3, formulation);
    Simulation moving = make_simulation(flight, kBooms + kHinges,
                                        IntegrationMethod::generalized_alpha, 5e-3, formulation);
    still.run_until(kDuration);
    moving.run_until(kDuration);
    CHECK(largest_difference(still, moving, "tip") < 1e-12);
    CHECK(largest_difference(still, moving, "hinges") < 1e-12);
    CHECK(moving.hub_pose().position.isApprox(spatial::Vector(30, 0, 10) * kDuration, 1e-12));
  }
}

TEST_CASE("a mount that is turned is a hub with another axis") {
  const double a = 0.7;
  const auto hub = [](const std::string& rest) {
    return "[hub]\nradius = 0.1\nmass = 2.0\ninertia = 0.5\n" + rest +
           "drive = { kind = \"torque\", torque = 3.0, initial_speed = 4.0 }\n";
  };
  Simulation turned = make_simulation(
      hub("mount = { rotation = { constant = [0, " + std::to_string(a) + ", 0] } }\n"), kBooms,
      IntegrationMethod::rk4, 2e-3);
  const std::string axis =
      "axis = [" + std::to_string(std::sin(0.7)) + ", 0, " + std::to_string(std::cos(0.7)) + "]\n";
  Simulation other = make_simulation(hub(axis), kBooms, IntegrationMethod::rk4, 2e-3);
  turned.run_until(kDuration);
  other.run_until(kDuration);
  // The axis is written with six digits.
  CHECK(largest_difference(turned, other, "") < 1e-5 * turned.sensor("energy.kinetic"));
  CHECK(largest_difference(turned, other, "hub.angle") < 1e-6);
}

TEST_CASE("a mount that spins about the axle is a drive") {
  const std::string booms = with_strain(kBooms, "nonlinear");
  const std::string hub =
      "[hub]\nradius = 0.1\nmass = 2.0\ncenter = [0.03, 0.02, 0]\ninertia = 0.5\n";
  Simulation driven = make_simulation(hub + "drive = { kind = \"constant\", speed = 4.0 }\n", booms,
                                      IntegrationMethod::rk4, 2e-3);
  Simulation carried = make_simulation(hub +
                                           "drive = { kind = \"fixed\" }\n"
                                           "mount = { rotation = { rate = [0, 0, 4.0] } }\n",
                                       booms, IntegrationMethod::rk4, 2e-3);
  driven.run_until(kDuration);
  carried.run_until(kDuration);
  CHECK(largest_difference(driven, carried, "tip") < 1e-11);
  CHECK(largest_difference(driven, carried, "energy") < 1e-9);
  CHECK(largest_difference(driven, carried, "hub.torque") < 1e-9);
  CHECK(carried.sensor("hub.speed") == 0.0);
  CHECK((driven.hub_reaction().force - carried.hub_reaction().force).norm() < 1e-8);
}

TEST_CASE("all three formulations give the motion on a ship, and its energies close") {
  for (const std::string& driven : {kDrivenHub, kTurnedHub}) {
    const std::string hub = driven + kShip;
    const std::string bodies = kBooms + kHinges;
    Simulation coarse = make_simulation(hub, bodies, IntegrationMethod::generalized_alpha, 5e-3);
    coarse.run_until(kDuration);
    for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented}) {
      Simulation other =
          make_simulation(hub, bodies, IntegrationMethod::generalized_alpha, 5e-3, formulation);
      other.run_until(kDuration);
      CHECK(largest_difference(coarse, other, "tip") < 1e-9);
      CHECK(largest_difference(coarse, other, "energy.kinetic") <
            1e-8 * coarse.sensor("energy.kinetic"));
      CHECK((coarse.hub_reaction().moment - other.hub_reaction().moment).norm() <
            1e-6 * coarse.hub_reaction().moment.norm());
    }
    // Without stops, whose stiffness jumps.
    const auto residual = [&hub](double step) {
      Simulation simulation =
          make_simulation(hub, kBooms, IntegrationMethod::generalized_alpha, step);
      simulation.run_until(kDuration);
      return simulation.sensor("energy.residual");
    };
    const double large = residual(2e-3), small = residual(5e-4);
    CAPTURE(large);
    CAPTURE(small);
    CHECK(std::abs(large / small) > 8.0);  // order two: 16
    CHECK(std::abs(small) < 1e-3 * coarse.sensor("energy.kinetic"));
  }
}

TEST_CASE("a spinning disc that is tilted resists by its gyroscopic moment") {
  const std::string disc = R"(
[[subsystem]]
name = "disc"
[[subsystem.body]]
name = "disc"
kind = "rigid"
mass = 2.0
inertia = [0.3, 0.3, 0.6]
[[subsystem.joint]]
parent = "hub"
child = "disc"
kind = "fixed"
)";
  for (const char* drive : {"drive = { kind = \"constant\", speed = 50.0 }\n",
                            "drive = { kind = \"free\", initial_speed = 50.0 }\n"}) {
    const std::string hub = "[hub]\ninertia = 1e-6\n" + std::string(drive) +
                            "mount = { rotation = { rate = [0.8, 0, 0] } }\n";
    Simulation simulation = make_simulation(hub, disc, IntegrationMethod::generalized_alpha, 1e-3,
                                            Formulation::structured, "");
    simulation.run_until(0.2);
    const double tilt = 0.8 * 0.2, moment = 0.6 * 50.0 * 0.8;
    const Eigen::Vector3d expected(0.0, -moment * std::cos(tilt), -moment * std::sin(tilt));
    CHECK((simulation.hub_reaction().moment - expected).norm() < 1e-4 * moment);
    CHECK(simulation.sensor("hub.speed") == doctest::Approx(50.0).epsilon(1e-9));
  }
}

TEST_CASE("a shaken cantilever answers as its first three modes say") {
  // L = rho A = EI = 1. Relative to a base that moves by A sin(W t), mode i moves its tip by
  // 4 s/l A W^2/(w^2 - W^2) (sin(W t) - W/w sin(w t)), w = l^2.
  const std::string beam = R"(
[blade]
count = 1
length = 1.0
bodies = 2
elements = 4
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e4
lag_stiffness = 1.0
flap_stiffness = 1.0
torsion_stiffness = 1.0
flap_inertia = 1e-6
lag_inertia = 1e-6
)";
  const double amplitude = 1e-3, W = 6.0, t = 0.4;
  const std::string hub =
      "[hub]\ndrive = { kind = \"fixed\" }\n"
      "mount = { translation = { amplitude = [0, 0, 1e-3], frequency = 6.0 } }\n";
  Simulation simulation = make_simulation(hub, beam, IntegrationMethod::generalized_alpha, 1e-3,
                                          Formulation::structured, "");
  simulation.run_until(t);
  double expected = 0.0;
  const double lambda[] = {1.875104, 4.694091, 7.854757}, sigma[] = {0.734096, 1.018467, 0.999224};
  const double sign[] = {1.0, -1.0, 1.0};
  for (int i = 0; i < 3; ++i) {
    const double w = lambda[i] * lambda[i];
    expected += sign[i] * 4.0 * sigma[i] / lambda[i] * amplitude * W * W / (w * w - W * W) *
                (std::sin(W * t) - W / w * std::sin(w * t));
  }
  CHECK(simulation.sensor("blade1.tip.z") == doctest::Approx(expected).epsilon(2e-3));
}

TEST_CASE("cyclic pitch follows the azimuth of a hub that a torque turns") {
  Simulation turned =
      make_simulation(kTurnedHub, kBooms + kPitch, IntegrationMethod::generalized_alpha, 2e-3);
  Simulation fine =
      make_simulation(kTurnedHub, kBooms + kPitch, IntegrationMethod::generalized_alpha, 0.5e-3);
  turned.run_until(kDuration);
  fine.run_until(kDuration);
  const double psi = turned.sensor("hub.angle");
  CHECK(turned.sensor("blade1.pitch") ==
        doctest::Approx(0.14 + 0.1 * std::cos(psi) - 0.15 * std::sin(psi)).epsilon(1e-12));
  const CoordinateMotion pitch = turned.joint_motion(0, turned.joint_index(0, "pitch"));
  CHECK(pitch.velocity == doctest::Approx((-0.1 * std::sin(psi) - 0.15 * std::cos(psi)) *
                                          turned.sensor("hub.speed")));
  const double ratio = std::abs(turned.sensor("energy.residual") / fine.sensor("energy.residual"));
  CAPTURE(turned.sensor("energy.residual"));
  CHECK(ratio > 8.0);
  CHECK(message_of([] {
          make_simulation(kTurnedHub, kBooms + kPitch, IntegrationMethod::rk4, 1e-3);
        }).find("expected \"generalized_alpha\"") != std::string::npos);
}
