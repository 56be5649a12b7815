// Tests rotors under loads of scenarios: closed forms, equal bits, saved states.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/engine/load_rotors.h"
#include "tests/engine/rotors.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

// Length of the blade of Wu & Haug [m].
constexpr double kLength = 8.0;
constexpr double kBendingStiffness = 8.214e-9 * 6.895e10;
constexpr double kMassPerLength = 2766.67 * 7.299e-5;

/// Makes one blade on a fixed hub, so damped that a slowly rising load bends it as at rest.
Scenario cantilever() {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(2, 4), 1);
  scenario.rotor.hub.drive = FixedDrive{};
  scenario.rotor.damping.stiffness_factor = 0.5;
  scenario.integration.duration = 40.0;
  scenario.integration.step = 0.02;
  return scenario;
}

Simulation at_rest(const Scenario& scenario) {
  Simulation simulation(scenario, kSerial);
  simulation.run_until(scenario.integration.duration);
  return simulation;
}

constexpr double kRamp = 20.0;

/// Makes stiff blades that turn freely about an axle, with drag per length.
Scenario spinning_rotor(double linear, double quadratic) {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(1, 4), 3);
  for (Blade& blade : scenario.rotor.blades) {
    blade.second_moment *= 1e5;
    blade.youngs_modulus *= 10.0;
  }
  scenario.rotor.hub.drive = FreeDrive{2.0};
  Drag drag;
  drag.linear_per_length = linear;
  drag.quadratic_per_length = quadratic;
  scenario.rotor.drags = {drag};
  scenario.integration.duration = 4.0;
  scenario.integration.step = 1e-3;
  return scenario;
}

const double kSpinningInertia = 1.0 + 3.0 * kMassPerLength * std::pow(kLength, 3) / 3.0;

}  // namespace

TEST_CASE(
    "a uniform load bends a cantilever by q L^4 / (8 EI), with q L and q L^2 / 2 at its root") {
  Scenario scenario = cantilever();
  DistributedLoad load;
  load.force_per_length = {0.0, 0.02};
  load.ramp = kRamp;
  scenario.rotor.distributed_loads = {load};
  const Simulation simulation = at_rest(scenario);
  CHECK(simulation.sensor("blade1.tip.y") ==
        approx(0.02 * std::pow(kLength, 4) / (8.0 * kBendingStiffness)).epsilon(1e-4));
  const Wrench root = simulation.joint_reaction(0, 0);
  CHECK(root.force.y() == approx(-0.02 * kLength).epsilon(1e-6));
  CHECK(root.moment.z() == approx(-0.02 * kLength * kLength / 2.0).epsilon(1e-4));
}

TEST_CASE("a uniform load on part of a blade bends it as its closed form says") {
  Scenario scenario = cantilever();
  const double a = 1.3, b = 5.9, q = 0.02;  // within elements of 1 m
  DistributedLoad load;
  load.from = a;
  load.to = b;
  load.force_per_length = {0.0, q};
  load.ramp = kRamp;
  scenario.rotor.distributed_loads = {load};
  // The integral of s^2 (3 L - s) / (6 EI) from a to b.
  const double expected =
      q / (6.0 * kBendingStiffness) *
      (kLength * (std::pow(b, 3) - std::pow(a, 3)) - (std::pow(b, 4) - std::pow(a, 4)) / 4.0);
  const Simulation simulation = at_rest(scenario);
  CHECK(simulation.sensor("blade1.tip.y") == approx(expected).epsilon(1e-4));
  CHECK(simulation.joint_reaction(0, 0).moment.z() ==
        approx(-q * (b * b - a * a) / 2.0).epsilon(1e-4));
}

TEST_CASE("a load acts where it is asked to, not at a node") {
  for (const double a : {2.0, 2.3, 3.97, 4.0, 7.5}) {
    Scenario scenario = cantilever();
    PointLoad load;
    load.position = a;
    load.force = {0.0, 0.1};
    load.ramp = kRamp;
    scenario.rotor.loads = {load};
    CAPTURE(a);
    const Simulation simulation = at_rest(scenario);
    CHECK(simulation.sensor("blade1.tip.y") ==
          approx(0.1 * a * a * (3.0 * kLength - a) / (6.0 * kBendingStiffness)).epsilon(1e-4));
    CHECK(simulation.joint_reaction(0, 0).moment.z() == approx(-0.1 * a).epsilon(1e-4));
  }
}

TEST_CASE("a load without a position acts on the tip of each blade, in code as in a file") {
  Scenario scenario = cantilever();
  Blade shorter = scenario.rotor.blades[0];
  shorter.length = 6.0;
  scenario.rotor.blades.push_back(shorter);
  PointLoad load;
  load.force = {0.0, 0.1};
  load.ramp = kRamp;
  scenario.rotor.loads = {load};
  const Simulation simulation = at_rest(scenario);
  CHECK(simulation.sensor("blade1.tip.y") == approx(0.1 * 512.0 / (3.0 * 566.355)).epsilon(1e-4));
  CHECK(simulation.sensor("blade2.tip.y") == approx(0.1 * 216.0 / (3.0 * 566.355)).epsilon(1e-4));
}

TEST_CASE("a load that rises slowly bends an undamped blade no further than at rest") {
  Scenario scenario = cantilever();
  scenario.rotor.damping = {};
  scenario.integration.duration = 40.0;
  PointLoad load;
  load.force = {0.0, 0.1};
  const double at_rest = 0.1 * std::pow(kLength, 3) / (3.0 * kBendingStiffness);
  const auto peak = [&](double ramp) {
    load.ramp = ramp;
    scenario.rotor.loads = {load};
    Simulation simulation(scenario, kSerial);
    const std::size_t tip = simulation.sensor_index("blade1.tip.y");
    double largest = 0.0;
    simulation.run_until(40.0, [&](double, std::span<const double> values) {
      largest = std::max(largest, values[tip]);
    });
    return largest;
  };
  CHECK(peak(30.0) == approx(at_rest).epsilon(1e-3));
  CHECK(peak(0.2) > 1.9 * at_rest);
}

TEST_CASE("gravity that rises bends a blade as its weight does, and its work is accounted for") {
  Scenario scenario = cantilever();
  scenario.rotor.gravity = {0.0, -0.1};
  scenario.rotor.gravity_ramp = kRamp;
  const Simulation simulation = at_rest(scenario);
  const double tip = -0.1 * kMassPerLength * std::pow(kLength, 4) / (8.0 * kBendingStiffness);
  CHECK(simulation.sensor("blade1.tip.y") == approx(tip).epsilon(1e-4));
  CHECK(std::abs(simulation.sensor("energy.residual")) < 1e-4 * simulation.sensor("energy.strain"));
}

TEST_CASE("a free rotor falls with gravity as it rises") {
  Scenario scenario = spinning_rotor(0.0, 0.0);
  scenario.rotor.drags.clear();
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 2.0;
  scenario.rotor.gravity = {0.0, -9.81};
  scenario.rotor.gravity_ramp = 1.0;
  scenario.integration.duration = 2.0;
  const Simulation simulation = at_rest(scenario);
  // The mean of the rise is one half.
  CHECK(simulation.hub().velocity[1] == approx(-9.81 * 1.5).epsilon(1e-6));
  CHECK(simulation.hub().acceleration[1] == approx(-9.81).epsilon(1e-6));
  CHECK(simulation.marker({0, 0, 0.0}).acceleration.y() == approx(-9.81).epsilon(1e-3));
  CHECK(std::abs(simulation.sensor("energy.residual")) <
        1e-5 * simulation.sensor("energy.kinetic"));
}

TEST_CASE("linear drag slows a rotor exponentially, quadratic drag as 1/(1 + c w0 t)") {
  const double linear = 0.02, quadratic = 0.01;
  const double k1 = 3.0 * linear * std::pow(kLength, 3) / 3.0 / kSpinningInertia;
  const double k2 = 3.0 * quadratic * std::pow(kLength, 4) / 4.0 / kSpinningInertia;
  for (const double t : {1.0, 4.0}) {
    Simulation slow(spinning_rotor(linear, 0.0), kSerial);
    slow.run_until(t);
    CHECK(slow.sensor("hub.speed") == approx(2.0 * std::exp(-k1 * t)).epsilon(1e-4));
    Simulation fast(spinning_rotor(0.0, quadratic), kSerial);
    fast.run_until(t);
    CHECK(fast.sensor("hub.speed") == approx(2.0 / (1.0 + k2 * 2.0 * t)).epsilon(1e-4));
  }
}

TEST_CASE("drag relative to the hub does not slow a rigid rotor") {
  Scenario scenario = spinning_rotor(0.02, 0.01);
  scenario.rotor.drags[0].relative_to = DragFrame::hub;
  CHECK(at_rest(scenario).sensor("hub.speed") == approx(2.0).epsilon(1e-4));
}

TEST_CASE("drag relative to the hub damps a vibration that it leaves no other way to end") {
  Scenario scenario = cantilever();
  scenario.rotor.damping = {};
  scenario.rotor.hub.drive = ConstantSpeed{0.5};
  Drag drag;
  drag.relative_to = DragFrame::hub;
  drag.linear_per_length = 0.2;  // c / (2 rhoA w) = 0.17 of the critical damping of the first mode
  scenario.rotor.drags = {drag};
  scenario.integration.duration = 60.0;
  const Simulation simulation = at_rest(scenario);
  const MarkerState tip = simulation.marker({0, 1, 1.0});
  const Eigen::Vector3d turning{-0.5 * tip.position.y(), 0.5 * tip.position.x(), 0.0};
  CHECK((tip.velocity - turning).norm() < 1e-6);
}

TEST_CASE("a motor by its table turns a rotor to where its torque balances the drag's") {
  Scenario scenario = spinning_rotor(0.05, 0.0);
  scenario.rotor.hub.drive = TorqueBySpeed{Curve({0.0, 10.0}, {40.0, 0.0}), 0.5, 0.0};
  scenario.integration.duration = 60.0;
  scenario.integration.step = 0.01;
  const double drag = 3.0 * 0.05 * std::pow(kLength, 3) / 3.0;
  const Simulation simulation = at_rest(scenario);
  CHECK(simulation.sensor("hub.speed") == approx(40.0 / (4.0 + drag)).epsilon(1e-5));
  CHECK(simulation.sensor("hub.torque") ==
        approx(40.0 - 4.0 * simulation.sensor("hub.speed")).epsilon(1e-9));
  CHECK(std::abs(simulation.sensor("energy.residual")) < 1e-3 * simulation.sensor("energy.work"));
}

TEST_CASE("a torque on the hub turns a rotor as one of its drive does, and a drive holds it") {
  Scenario by_drive = spinning_rotor(0.0, 0.0);
  by_drive.rotor.drags.clear();
  Scenario by_load = by_drive;
  by_drive.rotor.hub.drive = TorqueDrive{Curve(10.0), 2.0};
  HubLoad torque;
  torque.torque = 4.0;
  torque.position = {0.5, 0.0};
  torque.force = {1.0, 12.0};  // 6 N m more
  by_load.rotor.hub_loads = {torque};
  CHECK(at_rest(by_load).sensor("hub.speed") ==
        approx(at_rest(by_drive).sensor("hub.speed")).epsilon(1e-12));
  CHECK(at_rest(by_load).sensor("hub.torque") == 0.0);
  for (const Formulation formulation : {Formulation::structured, Formulation::augmented}) {
    by_load.rotor.hub.drive = FixedDrive{};
    by_load.integration.duration = 0.01;
    Simulation held(by_load, {formulation, ExecutorKind::serial, 1});
    held.run_until(0.01);
    CHECK(held.sensor("hub.torque") == approx(-10.0));
    CHECK(held.hub_reaction().force.y() == approx(-12.0));
    CHECK(held.sensor("energy.work") == approx(0.0).scale(1e-9));
  }
}

TEST_CASE("a fixed hub stands still, and one of constant speed turns from the start") {
  Scenario scenario = spinning_rotor(0.0, 0.0);
  scenario.rotor.hub.drive = FixedDrive{};
  const Simulation still = at_rest(scenario);
  CHECK(still.sensor("hub.angle") == 0.0);
  CHECK(still.sensor("energy.kinetic") == 0.0);
  scenario.rotor.hub.drive = ConstantSpeed{1.5};
  const Simulation turning = at_rest(scenario);
  CHECK(turning.sensor("hub.speed") == 1.5);
  CHECK(turning.sensor("hub.angle") == approx(6.0).epsilon(1e-12));
}

TEST_CASE("loads of scenarios have the same bits on every executor and window, and when resumed") {
  for (const bool is_prescribed : {true, false}) {
    Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.04);
    if (!is_prescribed) {
      scenario.rotor.hub.support = HubSupport::free;
      scenario.rotor.hub.drive = TorqueBySpeed{Curve({0.0, 2.0}, {0.2, -0.1}), 1.0, 0.5};
    }
    scenario.rotor.gravity = {0.0, -1.0};
    add_all_loads(scenario.rotor);
    const auto hash = [&](ExecutorKind kind, int window) {
      Simulation simulation(scenario, {Formulation::structured, kind, 2, window});
      simulation.run_until(0.04);
      return simulation.state_hash();
    };
    const std::uint64_t serial = hash(ExecutorKind::serial, 1);
    CHECK(serial == hash(ExecutorKind::serial, 15));
    for (const ExecutorKind kind : graph::executor_kinds()) CHECK(serial == hash(kind, 5));
    Simulation whole(scenario, kSerial), first(scenario, kSerial), second(scenario, kSerial);
    whole.run_until(0.04);
    first.run_until(0.017);
    second.restore(first.save());
    second.run_until(0.04);
    CHECK(serial == second.state_hash());
    CHECK(whole.sensor("energy.work") == second.sensor("energy.work"));
  }
}
