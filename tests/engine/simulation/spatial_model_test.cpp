// Tests a simulation of a model in space: its states, its views, changes between steps, and how it
// ends.

#include "engine/simulation/spatial_model.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 1};

Scenario make_scenario(const std::string& text, IntegrationMethod method, double step,
                       double duration) {
  Scenario scenario = parse_scenario(text, "test.toml");
  scenario.integration.method = method;
  scenario.integration.step = step;
  scenario.integration.duration = duration;
  scenario.limits.deflection = 0.0;
  return scenario;
}

std::shared_ptr<const Load> drag() {
  return make_load("drag", {{0, 0, 0.4}},
                   [](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                     out[0].force = -0.2 * in[0].velocity;
                   });
}

}  // namespace

TEST_CASE("a run in space that is saved and restored goes on with the bits of the whole run") {
  const std::string texts[] = {make_text(kDrivenHub, kBooms + kHinges + kPitch, kRisingGravity),
                               make_text(kTurnedHub, kBooms + kHinges, kGravity),
                               make_text(kFlyingHub, kTree + kMotors, kGravity),
                               make_text(kTurnedHub, kTree + kForest, kGravity)};
  for (const std::string& text : texts)
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
      const double step = method == IntegrationMethod::rk4 ? 1e-3 : 5e-3;
      const Scenario scenario = make_scenario(text, method, step, 40 * step);
      Simulation whole(scenario, kSerial, {drag()});
      whole.run_until(20 * step);
      const SavedState middle = whole.save();
      const std::vector<double> shown = values_of(whole);
      whole.run_until(40 * step);
      // Another simulation, which was elsewhere, on other threads and windows, shows the same.
      Simulation other(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, 7},
                       {drag()});
      other.run_until(13 * step);
      other.restore(middle);
      CHECK(other.steps() == 20);
      // Loads of the joints are those of the last evaluation, and no part of a state.
      CHECK(values_of(other).front() == shown.front());
      other.run_until(40 * step);
      CHECK(other.state_hash() == whole.state_hash());
      CHECK(values_of(other) == values_of(whole));
    }
}

TEST_CASE("a state in space of another model is refused") {
  const auto scenario = [](const std::string& bodies) {
    return make_scenario(make_text(kFlyingHub, bodies), IntegrationMethod::rk4, 1e-3, 0.1);
  };
  Simulation tree(scenario(kTree), kSerial), booms(scenario(kBooms), kSerial);
  const std::uint64_t before = booms.state_hash();
  CHECK(message_of([&] {
          booms.restore(tree.save());
        }).starts_with("the saved state is of another model"));
  CHECK(booms.state_hash() == before);
}

TEST_CASE("views that belong to the plane are refused of a model in space") {
  Simulation simulation(
      make_scenario(make_text(kFlyingHub, kTree), IntegrationMethod::rk4, 1e-3, 0.1), kSerial);
  const std::string reason = "the model is in space, expected a rotor in the plane";
  BladeShape shape;
  for (const std::string& message : {message_of([&] { simulation.hub(); }),
                                     message_of([&] { simulation.calc_shape(0, shape); })})
    CHECK(message.find(reason) != std::string::npos);
}

TEST_CASE("the hub's frame and the coordinates of bodies are seen in space") {
  for (const std::string& hub : {kFlyingHub, kDrivenHub}) {
    Simulation simulation(
        make_scenario(make_text(hub, kTree, kGravity), IntegrationMethod::rk4, 2.5e-4, 0.2),
        kSerial);
    constexpr double h = 2.5e-4;
    simulation.run_until(0.1);
    const HubFrame before = simulation.hub_frame();
    simulation.step();
    const HubFrame now = simulation.hub_frame();
    const BodyState boom = simulation.body(0, 0);
    simulation.step();
    const HubFrame after = simulation.hub_frame();
    const double slack = 1e-4;  // of differences
    CHECK((now.velocity - (after.position - before.position) / (2 * h)).norm() < slack);
    CHECK((now.acceleration - (after.velocity - before.velocity) / (2 * h)).norm() < 100 * slack);
    CHECK((now.angular_acceleration - (after.angular_velocity - before.angular_velocity) / (2 * h))
              .norm() < 100 * slack);
    const spatial::Tensor turning =
        (after.rotation - before.rotation) * now.rotation.transpose() / (2 * h);
    CHECK(std::abs(now.angular_velocity.z() - turning(1, 0)) < slack);
    CHECK(boom.coordinates.size() == 12);
    const auto shown = simulation.body(0, 0).coordinates;
    CHECK(shown[1] - boom.coordinates[1] ==
          doctest::Approx(0.5 * h * (boom.velocities[1] + simulation.body(0, 0).velocities[1]))
              .epsilon(1e-3));
    CHECK(simulation.body(0, 1).coordinates.empty());
    CHECK(message_of([&] { simulation.body(0, 9); }).find("the index of the body is 9") !=
          std::string::npos);
  }
}

TEST_CASE("another drive acts from the next step on, in space too") {
  const Scenario scenario = make_scenario(make_text(kTurnedHub, kBooms, ""),
                                          IntegrationMethod::generalized_alpha, 5e-3, 1.0);
  Simulation simulation(scenario, kSerial);
  simulation.run_until(0.1);
  const double speed = simulation.sensor("hub.speed");
  simulation.set_drive(TorqueDrive{Curve(-40.0)});
  CHECK(simulation.sensor("hub.speed") == speed);
  simulation.run_until(0.2);
  CHECK(simulation.sensor("hub.torque") == doctest::Approx(-40.0).epsilon(1e-9));
  CHECK(simulation.sensor("hub.speed") < speed - 0.1);
  // A drive that prescribes the motion cannot replace a torque.
  CHECK(message_of([&] { simulation.set_drive(SpinUp{8.0, 1.0}); }) != "no error");
  CHECK(std::get<TorqueDrive>(simulation.drive()).torque.value(0.0) == -40.0);
}

namespace {

/// A blade whose pitch the program moves, on a hub that turns.
const std::string kProgramPitch = R"(
[[blade.joint]]
name = "pitch"
station = 1.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { by = "program", initial = 0.1 }
)";

/// Makes a simulation in which the scenario prescribes the motion; a program that prescribes the
/// same must reach its values.
Simulation make_pitching(const std::string& pitch, IntegrationMethod method, int window) {
  const double step = method == IntegrationMethod::rk4 ? 1e-3 : 2e-3;
  const std::string text = make_text(kDrivenHub, kBooms + pitch, kGravity);
  Scenario scenario = make_scenario(text, method, step, 1.0);
  scenario.integration.iterations = 3;  // whatever round-off says
  return Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, window});
}

}  // namespace

TEST_CASE("the program moves a joint by a function of time: the same as the scenario's table") {
  const Curve course({0.0, 0.1, 0.2, 0.5, 0.6}, {0.1, 0.1, 0.3, -0.2, -0.2});
  std::string table = kProgramPitch;
  table.replace(table.find("by ="), table.find('}') - table.find("by ="),
                "time = [0.0, 0.1, 0.2, 0.5, 0.6], value = [0.1, 0.1, 0.3, -0.2, -0.2] ");
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    Simulation expected = make_pitching(table, method, 1);
    expected.run_until(0.4);
    for (const int window : {1, 7}) {
      Simulation simulation = make_pitching(kProgramPitch, method, window);
      const int pitch = simulation.joint_index(0, "pitch");
      simulation.run_until(0.06);
      for (const int blade : {0, 1}) simulation.set_joint_motion(blade, pitch, 0, course);
      simulation.run_until(0.4);
      // generalized_alpha restarts where a motion is set, which changes round-off.
      if (method == IntegrationMethod::rk4) CHECK(simulation.state_hash() == expected.state_hash());
      CHECK(simulation.sensor("blade2.tip.z") ==
            doctest::Approx(expected.sensor("blade2.tip.z")).epsilon(1e-8));
      CHECK(simulation.joint_motion(0, pitch).value == course.value(0.4));
    }
  }
}

TEST_CASE("the program moves a joint step by step, as a controller does, and the energies close") {
  Simulation simulation = make_pitching(kProgramPitch, IntegrationMethod::generalized_alpha, 0);
  const int pitch = simulation.joint_index(0, "pitch");
  while (simulation.time() < 0.3) {
    CoordinateMotion motion = simulation.joint_motion(0, pitch);
    motion.acceleration = 400.0 * (0.3 - motion.value) - 40.0 * motion.velocity;
    simulation.set_joint_motion(0, pitch, 0, motion);
    simulation.step();
  }
  CHECK(simulation.joint_motion(0, pitch).value == doctest::Approx(0.3).epsilon(0.05));
  CHECK(simulation.sensor("blade1.pitch") == simulation.joint_motion(0, pitch).value);
  CHECK(simulation.joint_motion(1, pitch).value == 0.1);
  CHECK(std::abs(simulation.sensor("energy.residual")) <
        2e-3 * simulation.sensor("energy.kinetic"));
}

TEST_CASE("empty braces are a motion of a joint, not its course") {
  Simulation simulation = make_pitching(kProgramPitch, IntegrationMethod::rk4, 1);
  const int pitch = simulation.joint_index(0, "pitch");
  const std::string message = message_of([&] { simulation.set_joint_motion(0, pitch, 0, {}); });
  CHECK(message.find("it begins at 0 with the rate 0 and acceleration 0, expected 0.1") !=
        std::string::npos);
  simulation.set_joint_motion(0, pitch, 0, Curve(0.1));  // a course that stays there
  CHECK(simulation.joint_motion(0, pitch).value == 0.1);
}

TEST_CASE(
    "a motion of a joint that is not the program's, or jumps, is refused and changes nothing") {
  Simulation simulation = make_pitching(kHinges + kProgramPitch, IntegrationMethod::rk4, 1);
  simulation.run_until(0.01);
  const int pitch = simulation.joint_index(0, "pitch"),
            hinges = simulation.joint_index(0, "hinges");
  const std::uint64_t before = simulation.state_hash();
  const auto refusal = [&](int tree, int joint, int coordinate, const CoordinateMotion& motion) {
    return message_of([&] { simulation.set_joint_motion(tree, joint, coordinate, motion); });
  };
  CHECK(refusal(0, pitch, 0, {0.2, 0.0, 0.0}) ==
        "the motion of coordinate 0 of joint " + std::to_string(pitch) +
            " (\"pitch\") of blade 1 does not go on from where it is at t = 0.01 s: it begins at "
            "0.2 with the rate 0 and acceleration 0, expected 0.1 and 0");
  CHECK(refusal(0, pitch, 0, {0.1, 0.0, std::nan("")}).find("acceleration nan") !=
        std::string::npos);
  CHECK(refusal(0, hinges, 1, {}).find("is free, expected one whose motion is prescribed") !=
        std::string::npos);
  CHECK(refusal(0, pitch, 1, {}).find("the coordinate of the joint is 1") != std::string::npos);
  CHECK(refusal(2, pitch, 0, {}).find("the index of the blade or subsystem is 2") !=
        std::string::npos);
  CHECK(refusal(0, 9, 0, {}).find("the index of the joint is 9") != std::string::npos);
  CHECK(message_of([&] { simulation.joint_index(0, "pich"); }) ==
        "no joint of blade 1 is named \"pich\", did you mean \"pitch\"?");
  Simulation cyclic = make_pitching(kPitch, IntegrationMethod::rk4, 1);
  CHECK(message_of([&] {
          cyclic.set_joint_motion(0, cyclic.joint_index(0, "pitch"), 0, CoordinateMotion{});
        }).find("follows the scenario") != std::string::npos);
  CHECK(simulation.state_hash() == before);
  CHECK(simulation.joint_motion(0, pitch).value == 0.1);
}

TEST_CASE("a model in space that diverges says which subsystem, body, node and quantity") {
  // One linear body without stiffening, beyond its critical speed.
  const std::string text = R"(world = "space"
[hub]
drive = { kind = "spin_up", speed = 12.0, ramp = 2.0 }
[[hub_load]]
torque = [0.0, 0.0, 1.0]
[blade]
count = 2
length = 2.0
bodies = 1
elements = 2
geometric_stiffening = false
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
[integration]
duration = 10.0
)";
  Simulation simulation(make_scenario(text, IntegrationMethod::generalized_alpha, 5e-3, 10.0),
                        kSerial);
  const std::string message = message_of<DivergenceError>([&] { simulation.run_until(10.0); });
  CAPTURE(message);
  CHECK(message.starts_with("diverged at t = "));
  for (const char* part :
       {"blade 1 / body 1", "of node ", "is beyond what its linear model can mean",
        "(node \"blade 1 / body 1 / recovery\")", "geometric_stiffening"})
    CHECK(message.find(part) != std::string::npos);
  CHECK(message_of<StateError>([&] {
          simulation.marker({0, 0, 1.0});
        }).find("there is no state to evaluate") != std::string::npos);
}

TEST_CASE("an iteration in space that does not converge is named with a body and what to set") {
  const std::string text = make_text(kDrivenHub, kBooms + kHinges, kGravity);
  Scenario scenario = make_scenario(text, IntegrationMethod::generalized_alpha, 0.1, 1.0);
  scenario.integration.max_iterations = 1;
  Divergence at;
  std::string message;
  try {
    Simulation(scenario, kSerial).run_until(1.0);
  } catch (const DivergenceError& error) {
    at = error.divergence();
    message = error.what();
  }
  CAPTURE(message);
  CHECK(at.quantity == "change of a coordinate");
  CHECK(at.subsystem.starts_with("blade "));
  CHECK(at.node == at.subsystem + " / " + at.body + " / recovery");
  for (const std::string& part :
       {std::string("the iteration still changes a coordinate by "),
        std::string("after 1 iteration, most in " + at.subsystem + " / " + at.body),
        std::string("set integration.step to 0.05 or less")})
    CHECK(message.find(part) != std::string::npos);
}
