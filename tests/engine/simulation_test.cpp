#include "engine/simulation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/simulation/node_measurement.h"
#include "models/error.h"
#include "tests/approx.h"
#include "tests/engine/rotors.h"
#include "tests/engine/serial.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {}

TEST_CASE("a simulation tells its size") {
  const Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  const ModelSize size = simulation.size();
  CHECK(size.subsystems == 3);
  CHECK(size.bodies == 12);
  CHECK(size.coordinates == 144);
  CHECK(size.joints == 12);
  CHECK(size.graph_nodes == 61);
  CHECK(simulation.planned_steps() == 4000);
  CHECK(simulation.time() == 0.0);
  CHECK(simulation.evaluations() == 1);
}

TEST_CASE("a sensor has a handle") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  simulation.run_until(1.0);
  const std::size_t speed = simulation.sensor_index("hub.speed");
  CHECK(simulation.sensor_names()[speed] == "hub.speed");
  CHECK(simulation.sensor_values()[speed] == simulation.sensor("hub.speed"));
  CHECK(simulation.sensor("hub.speed") == simulation.hub().velocity[kRotation]);
  CHECK_THROWS_AS(simulation.sensor_index("hub.sped"), InputError);
}

TEST_CASE("the hub follows its drive exactly and time does not drift") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  simulation.run_until(7.5);
  CHECK(simulation.time() == approx(7.5).epsilon(1e-15));
  CHECK(simulation.sensor("hub.angle") == approx(4.4603645).epsilon(1e-7));
  CHECK(simulation.hub().velocity[kRotation] == approx(2.0).epsilon(1e-12));
  CHECK(simulation.hub().acceleration[kRotation] == approx(0.53333333).epsilon(1e-8));
  simulation.run_until(1e9);
  CHECK(simulation.done());
  CHECK(simulation.time() == 20.0);
}

TEST_CASE("a step that does not divide the duration is shortened") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.3);
  scenario.integration.duration = 1.0;
  const Simulation simulation(scenario, kSerial);
  CHECK(simulation.planned_steps() == 4);
  CHECK(simulation.step_size() == 0.25);
}

TEST_CASE("a torque turns a stiff rotor as a rigid body") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
  for (Blade& blade : scenario.rotor.blades) blade.second_moment *= 1e4;
  scenario.rotor.hub.drive = TorqueDrive{Curve(10.0)};
  scenario.integration.duration = 2.0;
  Simulation simulation(scenario, kSerial);
  while (!simulation.done()) simulation.step();
  const double inertia = 1.0 + 3.0 * 0.2019392 * 8.0 * 8.0 * 8.0 / 3.0;
  CHECK(simulation.sensor("hub.speed") == approx(20.0 / inertia).epsilon(1e-3));
  CHECK(simulation.sensor("energy.work") ==
        approx(10.0 * simulation.sensor("hub.angle")).epsilon(1e-6));
}

TEST_CASE("a free rotor falls with gravity and an axle holds it") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
  scenario.rotor.gravity = Position{0.0, -9.81};
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 2.0;
  scenario.rotor.hub.drive = FreeDrive{};
  scenario.integration.duration = 1.0;
  Simulation falling(scenario, kSerial);
  while (!falling.done()) falling.step();
  CHECK(falling.sensor("hub.y") == approx(-0.5 * 9.81).epsilon(1e-9));
  CHECK(std::abs(falling.sensor("blade1.tip.y")) < 1e-9);

  scenario.rotor.hub.support = HubSupport::axle;
  Simulation held(scenario, kSerial);
  while (!held.done()) held.step();
  CHECK(std::abs(held.sensor("blade1.tip.y")) > 0.1);
  CHECK(std::abs(held.sensor("energy.residual")) < 1e-3);
}

TEST_CASE("a slowly growing tip force bends a damped blade as a cantilever") {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(), 1);
  scenario.rotor.hub.drive = SpeedTable{Curve(0.0)};
  scenario.rotor.damping.stiffness_factor = 0.5;
  PointLoad load;
  load.position = 8.0;
  load.force = Position{0.0, 0.1};
  load.factor = Curve({0.0, 40.0}, {0.0, 1.0});
  scenario.rotor.loads.push_back(load);
  scenario.integration.duration = 60.0;
  scenario.integration.step = 0.01;
  Simulation simulation(scenario, kSerial);
  while (!simulation.done()) simulation.step();
  CHECK(simulation.sensor("blade1.tip.y") == approx(0.1 * 512.0 / (3.0 * 566.355)).epsilon(1e-4));
  CHECK(simulation.sensor("energy.dissipated") > 0.0);
}

TEST_CASE("a fixed number of iterations is kept to") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.01);
  scenario.integration.iterations = 2;
  Simulation simulation(scenario, kSerial);
  for (int n = 0; n < 10; ++n) simulation.step();
  CHECK(simulation.evaluations() == 21);
}

TEST_CASE("an iteration that does not converge says so") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.05);
  scenario.integration.max_iterations = 1;
  Simulation simulation(scenario, kSerial);
  CHECK_THROWS_WITH_AS(simulation.run_until(5.0), doctest::Contains("tolerance"), DivergenceError);
}

TEST_CASE("sensors have names and units, and an unknown name is refused") {
  const Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  CHECK(simulation.sensor_names().size() == simulation.sensor_units().size());
  CHECK(simulation.sensor_names().size() == simulation.sensor_values().size());
  CHECK(simulation.sensor_names().front() == "blade1.tip.x");
  CHECK_THROWS_AS(simulation.sensor("blade9.tip.x"), InputError);
}

TEST_CASE("the state of a body is told in the order axial, bending") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  simulation.run_until(5.0);
  const BodyState tip = simulation.body(0, 3);
  REQUIRE(tip.coordinates.size() == 12);
  CHECK(std::abs(tip.coordinates[3]) < 1e-3);  // u: stretched little
  CHECK(tip.coordinates[10] < -1e-3);          // v: lags
  CHECK_THROWS_AS(simulation.body(0, 4), InputError);
  CHECK_THROWS_AS(simulation.body(3, 0), InputError);
}

TEST_CASE("a model beyond the machine's memory is refused before anything is allocated") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1000, 20), 0.005);
  CHECK_THROWS_WITH_AS(Simulation(scenario, {Formulation::augmented, ExecutorKind::serial, 1}),
                       doctest::Contains("memory"), InputError);
  scenario.rotor = make_rotor(wu_haug_blade(100000, 1), 1);
  CHECK_THROWS_WITH_AS(Simulation(scenario, {Formulation::subsystem, ExecutorKind::serial, 1}),
                       doctest::Contains("memory"), InputError);
}

TEST_CASE("simulations may be moved") {
  Simulation first(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  first.step();
  Simulation second = std::move(first);
  second.step();
  CHECK(second.steps() == 2);
}

TEST_CASE("a scenario filled in code with nonsense is refused, by its key") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.005);
  scenario.rotor.blades[1].length = -8.0;
  CHECK(message_of([&] { Simulation(scenario, kSerial); }) ==
        "blades.2.length: is -8, expected a number greater than 0 (m)");
  scenario.rotor.blades.clear();
  CHECK(message_of([&] { Simulation(scenario, kSerial); }) ==
        "blades: there are none, expected one or more");
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  CHECK(message_of([&] {
          simulation.set_drive(SpinUp{4.0, -1.0});
        }) == "hub.drive.ramp: is -1, expected a number greater than 0 (s)");
}

TEST_CASE("options that are none are refused") {
  const Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.005);
  CHECK(message_of([&] {
          Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, -1});
        }) == "SimulationOptions::window is -1, expected 0 to 1000");
  CHECK(message_of([&] {
          Simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, -2});
        }) == "number of threads: expected 0 (all available) or more, got -2");
  CHECK(message_of([&] {
          Simulation(scenario, {Formulation::structured, ExecutorKind::automatic, 100000});
        }) == "number of threads: expected at most 1024 in all, got 100000");
}

TEST_CASE("what does not exist is refused with what was expected") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  CHECK(message_of([&] { simulation.sensor("blade1.tip.w"); }) ==
        "no sensor is named \"blade1.tip.w\", did you mean \"blade1.tip.x\"?");
  CHECK(message_of([&] { simulation.sensor("temperature"); }) ==
        "no sensor is named \"temperature\", expected one of sensor_names()");
  CHECK(message_of([&] { simulation.body(3, 0); }) ==
        "the index of the blade is 3, expected 0 to 2");
  CHECK(message_of([&] { simulation.body(0, -1); }) ==
        "the index of the body is -1, expected 0 to 3");
  BladeShape shape;
  CHECK(message_of([&] { simulation.calc_shape(-1, shape); }) ==
        "the index of the blade is -1, expected 0 to 2");
  CHECK(message_of([&] { simulation.trace(0); }) ==
        "the number of steps to trace is 0, expected 1 to 4000");
  Scenario ended = spin_up_scenario(wu_haug_blade(), 0.005);
  ended.integration.duration = 0.005;
  Simulation at_end(ended, kSerial);
  CHECK(message_of([&] { at_end.trace(2); }) == "the number of steps to trace is 2, expected 1");
  at_end.step();
  CHECK(message_of([&] { at_end.trace(1); }) == "the number of steps to trace is 1, expected none");
  CHECK(message_of([&] { measure_nodes(simulation, 4001); }) ==
        "the number of steps to measure is 4001, expected 1 to 4000");
}

TEST_CASE("a time that is no number is refused, and infinity is the end") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.5), kSerial);
  CHECK(message_of([&] { simulation.run_until(std::nan("")); }) ==
        "run_until(): the time is not a number");
  CHECK(simulation.steps() == 0);
  simulation.run_until(-std::numeric_limits<double>::infinity());
  CHECK(simulation.steps() == 0);
  simulation.run_until(std::numeric_limits<double>::infinity());
  CHECK(simulation.done());
}

TEST_CASE("every error of the library has a code") {
  const auto code_of = [](const auto& function) {
    try {
      function();
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::internal;
  };
  const Scenario scenario = spin_up_scenario(wu_haug_blade(), 0.005);
  Simulation simulation(scenario, kSerial);
  CHECK(code_of([&] { simulation.sensor("none"); }) == ErrorCode::bad_input);
  CHECK(code_of([&] { simulation.restore({}); }) == ErrorCode::bad_input);
  CHECK(code_of([] { Curve({}, {}); }) == ErrorCode::bad_input);
  CHECK(code_of([] { graph::executor_kind("none"); }) == ErrorCode::bad_input);
  const auto load = [](auto function) { return make_load("broken", {Marker{}}, function); };
  CHECK(code_of([&] {
          Simulation(scenario, kSerial, {load([](double, auto, auto) { throw 1; })});
        }) == ErrorCode::load_failed);
  Scenario hopeless = scenario;
  hopeless.integration.max_iterations = 1;
  hopeless.integration.step = 0.05;
  Simulation diverging(hopeless, kSerial);
  CHECK(code_of([&] { diverging.run_until(5.0); }) == ErrorCode::diverged);
  CHECK(code_of([&] { diverging.save(); }) == ErrorCode::no_state);
}
