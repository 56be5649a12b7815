// Tests clones of simulations: a clone goes on to the bits that its original would go on to, by
// itself.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/courses.h"
#include "engine/results.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/load_rotors.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kOneThread{Formulation::structured, ExecutorKind::serial, 1, 1};

/// A shipped model, shortened to some steps.
struct ShippedModel {
  const char* name;
  double step = 0.0;  ///< [s]
  std::vector<std::string> changes{};
};

constexpr int kSteps = 24;

Scenario read_short(const ShippedModel& shipped) {
  std::vector<std::string> changes = shipped.changes;
  changes.push_back("integration.step=" + std::to_string(shipped.step));
  changes.push_back("integration.duration=" + std::to_string(kSteps * shipped.step));
  return read_shipped(shipped.name, changes);
}

/// All that a simulation shows from where it stands to its end.
struct Rest {
  std::vector<std::vector<double>> rows;
  std::uint64_t hash = 0;
  std::int64_t evaluations = 0;
  std::string summary;

  bool operator==(const Rest&) const = default;
};

/// Goes on to the end. The summary has what the executor has come to, unless there is one.
Rest go_on(Simulation& simulation, bool with_summary = true) {
  Rest rest;
  SensorStatistics statistics(simulation.sensor_names().size());
  const auto take = [&](double t, std::span<const double> values) {
    rest.rows.emplace_back(values.begin(), values.end());
    statistics.add(t, values);
  };
  take(simulation.time(), simulation.sensor_values());
  simulation.run_until(simulation.scenario().integration.duration, take);
  rest.hash = simulation.state_hash();
  rest.evaluations = simulation.evaluations();
  if (with_summary) rest.summary = make_summary(simulation, statistics, {});
  return rest;
}

void advance_by(int steps, Simulation& simulation) {
  simulation.run_until((static_cast<double>(simulation.steps()) + steps) * simulation.step_size(),
                       [](double, std::span<const double>) {});
}

/// Clones a simulation and lets the clone, the original and one that was never cloned go on.
void check_clone(Simulation original, Simulation alone, int steps) {
  advance_by(steps, original);
  advance_by(steps, alone);
  Simulation clone = original.clone();
  CHECK(clone.steps() == original.steps());
  CHECK(clone.state_hash() == original.state_hash());
  const Rest expected = go_on(alone), rest = go_on(clone);
  CHECK(rest == expected);
  CHECK(go_on(original) == expected);
}

}  // namespace

TEST_CASE("a clone of a shipped model goes on as the original") {
  const ShippedModel models[] = {{"wu_haug_rotor", 0.005},     {"paper_rotor", 0.005},
                                 {"articulated_rotor", 0.002}, {"free_hub_satellite", 0.005},
                                 {"helicopter_rotor", 0.002},  {"four_bar", 0.002},
                                 {"vehicle", 0.002},           {"bricard", 0.002},
                                 {"solid_blade_rotor", 0.002}, {"whirl_rotor", 0.001},
                                 {"nrel_5mw_turbine", 0.01}};
  for (const ShippedModel& model : models)
    for (const int steps : {0, 9}) {
      CAPTURE(model.name);
      CAPTURE(steps);
      const Scenario scenario = read_short(model);
      check_clone(Simulation(scenario, kOneThread), Simulation(scenario, kOneThread), steps);
    }
}

TEST_CASE("a clone in turbulent wind has the states of inflow and of controllers") {
  const Scenario scenario = read_short({"nrel_5mw_in_wind", 0.02});
  check_clone(Simulation(scenario, kOneThread), Simulation(scenario, kOneThread), 11);
}

TEST_CASE("a clone goes on as the original with each formulation, method and executor") {
  for (const char* name : {"wu_haug_rotor", "four_bar"})
    for (const char* method : {"rk4", "generalized_alpha"})
      for (const Formulation formulation : formulations())
        for (const ExecutorKind kind : {ExecutorKind::automatic, ExecutorKind::flow_graph}) {
          CAPTURE(name);
          CAPTURE(method);
          CAPTURE(name_of(formulation));
          CAPTURE(name_of(kind));
          const Scenario scenario =
              read_short({name, 1e-4, {std::string("integration.method=\"") + method + "\""}});
          Simulation original(scenario, {formulation, kind, 2, 0});
          advance_by(7, original);
          Simulation clone = original.clone();
          CHECK(go_on(clone, false) == go_on(original, false));
        }
}

TEST_CASE("clones outlive their original, may be cloned, and run beside one another") {
  std::optional<Simulation> original(std::in_place, read_short({"articulated_rotor", 0.002}),
                                     kOneThread);
  advance_by(5, *original);
  std::vector<Simulation> clones;
  for (int k = 0; k < 3; ++k) clones.push_back(k == 0 ? original->clone() : clones.back().clone());
  std::vector<Rest> rests(clones.size());
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < clones.size(); ++k)
    threads.emplace_back([&, k] { rests[k] = go_on(clones[k]); });
  const Rest expected = go_on(*original);
  for (std::thread& thread : threads) thread.join();
  for (const Rest& rest : rests) CHECK(rest == expected);
  original.reset();
  CHECK(go_on(clones[0]).hash == expected.hash);  // at its end already
}

TEST_CASE("a clone has the loads of the user's in force, the replaced ones too") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
    Scenario scenario = soft_scenario(method, 0.01);
    Sensor sensor{SensorQuantity::section_force, "inside", BladeChoice::all(), {}, {}, {}};
    sensor.position = 1.1;
    scenario.sensors.push_back(sensor);
    const Loads loads{demanding_load(0), follower({1, 1, 0.7}, 0.4, 0.1)};
    Simulation original(scenario, kOneThread, loads);
    advance_by(20, original);
    original.set_load(1, follower({1, 1, 0.7}, -0.6, 0.2));
    advance_by(3, original);
    Simulation clone = original.clone();
    const Marker tip{1, 1, 0.9};
    CHECK(clone.marker(tip).acceleration == original.marker(tip).acceleration);
    CHECK(clone.section_force(tip).force == original.section_force(tip).force);
    CHECK(go_on(clone) == go_on(original));
  }
}

namespace {

/// Two blades that loads by one name push, and a section that feels them.
std::string end_of_pushed(const std::string& force, const std::string& torque) {
  return "[[load]]\nname = \"push\"\nforce = " + force +
         "\n[[hub_load]]\nname = \"push\"\ntorque = " + torque + R"(
[[sensor]]
quantity = "section_force"
name = "inside"
position = 0.7
[integration]
step = 0.005
duration = 0.5
)";
}

Scenario make_pushed(bool in_space) {
  if (in_space)
    return parse_scenario("world = \"space\"\n" + kTurnedHub + kBooms +
                              end_of_pushed("[0.0, 1.0, 2.0]", "[0.0, 0.0, 1.0]"),
                          "pushed");
  return parse_scenario(R"(
[hub]
inertia = 5.0
drive = { kind = "torque", torque = 2.0, initial_speed = 1.0 }
[blade]
count = 2
length = 4.0
bodies = 2
elements = 2
density = 2700.0
area = 1e-4
second_moment = 1e-8
youngs_modulus = 7e10
)" + end_of_pushed("[0.0, 3.0]", "1.5"),
                        "pushed");
}

}  // namespace

TEST_CASE("what is set on a clone does not reach the original") {
  for (const bool in_space : {false, true}) {
    CAPTURE(in_space);
    const Scenario scenario = make_pushed(in_space);
    Simulation original(scenario, kOneThread), alone(scenario, kOneThread);
    for (Simulation* simulation : {&original, &alone}) {
      advance_by(10, *simulation);
      set_load_factor(*simulation, "push", 2.0);
    }
    Simulation clone = original.clone(), same = original.clone(), scaled = original.clone();
    CHECK(courses(clone).loads[0].factor == 2.0);
    set_load_factor(clone, "push", -3.0);
    set_load_factor(scaled, "push", -3.0);
    clone.set_drive(TorqueDrive{Curve(-4.0), 1.0});
    const Rest expected = go_on(alone);
    CHECK(go_on(clone).hash != expected.hash);
    CHECK(go_on(original) == expected);
    CHECK(go_on(same) == expected);
    Simulation other(scenario, kOneThread);
    advance_by(10, other);
    for (const double factor : {2.0, -3.0}) set_load_factor(other, "push", factor);
    CHECK(go_on(scaled) == go_on(other));
  }
}

TEST_CASE("a clone has the motions of joints and the wind that the program has set") {
  const Scenario scenario =
      read_short({"nrel_5mw_in_wind",
                  0.02,
                  {"control={}", R"(blade.joint.1.motion={by="program", initial=-0.067})",
                   R"(hub.drive={kind="torque", torque=-4.18e6, initial_speed=1.2671})",
                   R"(initial={state="undeformed"})", "wind={velocity=[12, 0, 0]}"}});
  Simulation original(scenario, kOneThread), alone(scenario, kOneThread);
  for (Simulation* simulation : {&original, &alone}) {
    advance_by(4, *simulation);
    const int joint = simulation->joint_index(1, "pitch");
    CoordinateMotion motion = simulation->joint_motion(1, joint);
    motion.acceleration = 0.3;
    simulation->set_joint_motion(1, joint, 0, motion);
    const double t = simulation->time();
    set_wind(*simulation, {t, t + 0.2, {12.0, 0.0, 0.0}, {14.0, 1.0, 0.0}});
    advance_by(3, *simulation);
  }
  Simulation clone = original.clone(), other = original.clone();
  CHECK(clone.joint_motion(1, clone.joint_index(1, "pitch")).acceleration == 0.3);
  CHECK(wind_at_hub(clone) == wind_at_hub(original));
  const double t = other.time();
  set_wind(other, {t, t + 0.1, wind_at_hub(other), {8.0, 0.0, 0.0}});
  const Rest expected = go_on(alone);
  CHECK(go_on(other).hash != expected.hash);
  CHECK(go_on(clone) == expected);
  CHECK(go_on(original) == expected);
}

TEST_CASE("a clone has the motion of an anchor that the program has set") {
  const Scenario scenario = parse_scenario(R"(
world = "space"
gravity = { acceleration = [0.0, 0.0, -9.81] }
[hub]
drive = { kind = "fixed" }
[[anchor]]
name = "winch"
motion = { by = "program" }
[[subsystem]]
name = "crane"
[[subsystem.body]]
name = "boom"
kind = "rigid"
mass = 20.0
center = [1.0, 0.0, 0.0]
inertia = [0.1, 7.0, 7.0]
[[subsystem.joint]]
name = "hinge"
parent = "hub"
child = "boom"
kind = "revolute"
axis = [0.0, -1.0, 0.0]
[[subsystem.loop]]
name = "rope"
kind = "distance"
from = { body = "boom", point = [2.0, 0.0, 0.0] }
to = { anchor = "winch", point = [2.0, 0.0, 1.0] }
[[sensor]]
quantity = "loop_reaction"
name = "rope"
subsystem = "crane"
loop = "rope"
[integration]
duration = 0.4
step = 0.01
)",
                                           "crane");
  Simulation original(scenario, kOneThread);
  advance_by(5, original);
  AnchorMotion motion = original.anchor_motion("winch");
  motion.acceleration.z() = 0.5;
  original.set_anchor_motion("winch", motion);
  advance_by(5, original);
  Simulation clone = original.clone(), still = original.clone();
  CHECK(clone.loop_reaction(0, "rope").force == original.loop_reaction(0, "rope").force);
  motion = still.anchor_motion("winch");
  motion.acceleration.setZero();
  still.set_anchor_motion("winch", motion);
  const Rest expected = go_on(original);
  CHECK(go_on(still).hash != expected.hash);
  CHECK(go_on(clone) == expected);
}

TEST_CASE("a clone can be saved and restored as its original") {
  const Scenario scenario = read_short({"four_bar", 0.002});
  Simulation original(scenario, kOneThread);
  const SavedState start = original.save();
  advance_by(6, original);
  Simulation clone = original.clone();
  CHECK(make_checkpoint(clone.save()) == make_checkpoint(original.save()));
  CHECK(clone.loops_at_start().redundant == original.loops_at_start().redundant);
  original.restore(start);
  clone.restore(start);
  CHECK(go_on(clone) == go_on(original));
}

TEST_CASE("what cannot be cloned is refused in one sentence") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 4), 0.005);
  scenario.rotor.blades[1].geometric_stiffening = false;  // which fails beyond 3 rad/s
  scenario.integration.duration = 12.0;
  Simulation simulation(scenario, kOneThread);
  std::string message;
  simulation.run_until(0.05, [&](double, std::span<const double>) {
    message = message_of<StateError>([&] { simulation.clone(); });
  });
  CHECK(message ==
        "the simulation cannot be cloned by an observer or a load that it calls, expected a call "
        "between steps");
  CHECK(simulation.clone().state_hash() == simulation.state_hash());
  const SavedState good = simulation.save();
  CHECK_THROWS_AS(simulation.run_until(12.0), DivergenceError);
  CHECK(message_of<StateError>([&] { simulation.clone(); }) ==
        "there is no state to clone: a step failed or was not brought to its end");
  simulation.restore(good);
  CHECK(simulation.clone().state_hash() == simulation.state_hash());
}
