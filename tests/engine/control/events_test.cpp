// Events: when they act, closed forms of what they do, and that they change no bits by how a
// simulation is run.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/courses.h"
#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "models/error.h"
#include "models/reader/scenario_json.h"
#include "tests/engine/control/vanes.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"

using namespace spoke;
using namespace spoke::test;
using doctest::Approx;

namespace {

constexpr double kStep = 0.005;  // of make_vanes()

const std::string kTurbine = "[control.turbine]\njoint = \"pitch\"\n";
const std::string kLaw =
    "[control.pitch]\njoint = \"pitch\"\nspeed = 1.9\nproportional = 0.3\nintegral = 0.2\n"
    "minimum = -0.5\nmaximum = 0.5\ninitial = 0.0\nperiod = 0.015\n";

std::string event(const std::string& keys) { return "[[event]]\n" + keys; }

Scenario make_machine(const std::string& control, const std::string& more = {}) {
  return parse_scenario(make_vanes(control, more), "vanes.toml");
}

Simulation make_run(const std::string& control, const std::string& more = {},
                    std::shared_ptr<Controller> controller = nullptr) {
  return Simulation(make_machine(control, more),
                    {.executor = ExecutorKind::serial, .controller = std::move(controller)});
}

/// Replaces the drive of make_vanes() by one of this text.
Scenario with_drive(const std::string& drive, const std::string& more) {
  std::string text = make_vanes("", more);
  const std::string own = "kind = \"torque\"\ntorque = 0.0\n";
  text.replace(text.find(own), own.size(), drive);
  return parse_scenario(text, "vanes.toml");
}

/// A chain of everything that events do, under control.
const std::string kStory =
    kLift + event("name = \"fast\"\nwhen = \"hub.speed > 2.001\"\npitch = { blades = [2] }\n") +
    event(
        "name = \"stop\"\nwhen = \"hub.speed < 1.97\"\ndelay = 0.02\ngenerator = \"off\"\n"
        "pitch = { to = 0.4, rate = 0.8, blades = [1, 3] }\n") +
    event("at = 0.7\nbrake = 3.0\ncontroller = \"off\"\n");
const std::string kStoryDrive =
    "kind = \"torque\"\ntorque = [0.0, 4.0, -6.0]\ntime = [0.0, 0.1, 0.4]\n";

Scenario make_story() {
  std::string text = make_vanes(kLaw, kStory);
  const std::string own = "kind = \"torque\"\ntorque = 0.0\n";
  text.replace(text.find(own), own.size(), kStoryDrive);
  return parse_scenario(text, "vanes.toml");
}

Simulation tell(ExecutorKind executor = ExecutorKind::serial, int threads = 1) {
  return Simulation(make_story(), {.executor = executor, .threads = {threads, 1}});
}

/// Demands a pitch that moves at a rate, at each step.
class Ramp final : public Controller {
 public:
  void control(const ControlRecord& record, ControlCommands& commands) override {
    for (double& pitch : commands.pitch) pitch = std::min(0.2, pitch + 0.4 * record.period);
    commands.torque = 0.0;
  }
};

/// Holds all angles and the torque that it begins with.
class Holder final : public Controller {
 public:
  void control(const ControlRecord& record, ControlCommands& commands) override {
    ++calls;
    for (double& pitch : commands.pitch) pitch = 0.05 * std::sin(3.0 * record.time);
    commands.torque = 1.5;
  }
  int calls = 0;
};

}  // namespace

TEST_CASE("without a generator a brake slows a hub evenly, and holds it") {
  // The brake has its whole torque above brake_speed: the speed falls at torque/inertia.
  Simulation simulation(with_drive("kind = \"torque\"\ntorque = 5.0\n",
                                   event("at = 0.5\ngenerator = \"off\"\nbrake = 35.0\n")),
                        {.executor = ExecutorKind::serial});
  simulation.run_until(0.5);
  const double fast = 2.0 + 5.0 * 0.5 / kVaneInertia;
  CHECK(simulation.sensor("hub.speed") == Approx(fast).epsilon(1e-10));
  simulation.run_until(1.0);
  CHECK(simulation.sensor("hub.speed") == Approx(fast - 35.0 * 0.5 / kVaneInertia).epsilon(1e-9));
  simulation.run_until(3.0);
  CHECK(std::abs(simulation.sensor("hub.speed")) < 1e-6);
  const double energy = 0.5 * kVaneInertia * fast * fast;
  CHECK(simulation.sensor("energy.kinetic") < 1e-9 * energy);
  REQUIRE(simulation.events().size() == 1);
  CHECK(simulation.events()[0].name == "event 1");
  CHECK(*simulation.events()[0].time == Approx(0.5));
}

TEST_CASE("events keep the balance of the energy") {
  // The error of a step at which a torque jumps vanishes with the step, as that of all others.
  const auto residual = [](double step) {
    Scenario scenario = make_machine(
        kTurbine, kLift + event("at = 0.3\npitch = { to = 0.4, rate = 0.8, blades = [1, 3] }\n") +
                      event("at = 0.6\nbrake = 30.0\n"));
    scenario.integration.step = step;
    Simulation simulation(scenario, {.executor = ExecutorKind::serial});
    double largest = 0.0;
    const std::size_t at = simulation.sensor_index("energy.residual");
    simulation.run_until(3.0, [&](double, std::span<const double> values) {
      largest = std::max(largest, std::abs(values[at]));
    });
    CHECK(simulation.sensor("vane1.pitch") == 0.4);
    CHECK(std::abs(simulation.sensor("hub.speed")) < 0.01);
    return largest;
  };
  const double energy = 0.5 * kVaneInertia * 2.0 * 2.0;
  CHECK(residual(0.005) < 1e-3 * energy);
  CHECK(residual(0.00125) < 0.1 * residual(0.005));
}

TEST_CASE("a brake adds its torque to that of a generator by the speed") {
  const std::string drive =
      "kind = \"torque_by_speed\"\nspeed = [1.0, 3.0]\ntorque = [-1.0, -5.0]\n";
  Simulation braked(with_drive(drive, event("at = 0.0\nbrake = 2.0\n")),
                    {.executor = ExecutorKind::serial});
  Simulation shifted(
      with_drive("kind = \"torque_by_speed\"\nspeed = [1.0, 3.0]\ntorque = [-3.0, -7.0]\n", ""),
      {.executor = ExecutorKind::serial});
  braked.run_until(2.0);
  shifted.run_until(2.0);
  CHECK(shifted.sensor("hub.speed") > 1.0);
  CHECK(braked.sensor("hub.speed") == Approx(shifted.sensor("hub.speed")).epsilon(1e-12));
}

TEST_CASE("an event acts at the end of the first step at which its condition holds, or later") {
  Simulation simulation(
      with_drive(
          "kind = \"torque\"\ntorque = 17.5\n",
          event("name = \"fast\"\nwhen = \"hub.speed > 2.5021\"\nbrake = 1.0\n") +
              event("name = \"late\"\nwhen = \"hub.speed>2.5021\"\ndelay = 0.023\nbrake = 2.0\n") +
              event("name = \"timed\"\nat = 0.6012\nbrake = 3.0\n") +
              event("name = \"never\"\nwhen = \"hub.speed < -1\"\nbrake = 3.0\n")),
      {.executor = ExecutorKind::serial});
  simulation.run_until(1.0);
  const std::vector<EventInRun> events = simulation.events();
  REQUIRE(events.size() == 4);
  CHECK(*events[0].time == Approx(0.505));  // the speed is 2 + t
  CHECK(*events[1].time == Approx(0.53));   // 0.528, at the end of a step
  CHECK(*events[2].time == Approx(0.605));
  CHECK(!events[3].time);
}

TEST_CASE("an event pitches blades as a controller does that demands the same angles") {
  const std::string program = "[control.program]\njoint = \"pitch\"\nperiod = 0.1\n";
  Simulation demanded = make_run(program, kLift, std::make_shared<Ramp>());
  Simulation pitched =
      make_run(kTurbine, kLift + event("at = 0.0\npitch = { to = 0.2, rate = 0.4 }\n"));
  for (const double t : {0.1, 0.5, 1.0}) {
    demanded.run_until(t);
    pitched.run_until(t);
    CHECK(pitched.sensor("vane2.pitch") == demanded.sensor("vane2.pitch"));
    CHECK(pitched.sensor("hub.speed") == demanded.sensor("hub.speed"));
  }
  CHECK(pitched.sensor("vane2.pitch") == 0.2);
}

TEST_CASE("a stuck blade stops smoothly while a controller goes on with the others") {
  const auto holder = std::make_shared<Holder>();
  Simulation simulation = make_run("[control.program]\njoint = \"pitch\"\nperiod = 0.02\n",
                                   event("at = 0.303\npitch = { blades = [3] }\n"), holder);
  const std::size_t stuck = simulation.sensor_index("vane3.pitch");
  const std::size_t free = simulation.sensor_index("vane1.pitch");
  double before = 0.0, largest_change = 0.0, last_rate = 0.0;
  simulation.run_until(1.0, [&](double t, std::span<const double> values) {
    const double rate = (values[stuck] - before) / kStep;
    if (t > 0.1) largest_change = std::max(largest_change, std::abs(rate - last_rate));
    before = values[stuck];
    last_rate = rate;
    if (t < 0.304) CHECK(values[stuck] == values[free]);
  });
  // It had a rate of 0.15 cos(0.9), and is at rest three demands after the event.
  CHECK(largest_change < 0.1 * 0.15 * std::cos(0.9));
  CHECK(last_rate == 0.0);
  CHECK(simulation.sensor("vane3.pitch") == Approx(0.05 * std::sin(3.0 * 0.38)).epsilon(0.1));
  CHECK(simulation.sensor("vane1.pitch") == Approx(0.05 * std::sin(3.0 * 0.96)).epsilon(0.02));
  CHECK(holder->calls == 50);
}

TEST_CASE("a controller that is off is called no more: all stays as it is demanded last") {
  const auto holder = std::make_shared<Holder>();
  Simulation simulation = make_run("[control.program]\njoint = \"pitch\"\n",
                                   event("at = 0.5\ncontroller = \"off\"\n"), holder);
  simulation.run_until(0.9);
  CHECK(holder->calls == 100);
  const double angle = simulation.sensor("vane1.pitch"), speed = simulation.sensor("hub.speed");
  simulation.run_until(1.0);
  CHECK(holder->calls == 100);
  CHECK(simulation.sensor("vane1.pitch") == angle);
  CHECK(simulation.sensor("hub.speed") == Approx(speed + 0.1 * 1.5 / kVaneInertia).epsilon(1e-9));
}

TEST_CASE("a run with an event has the bits of one without, up to the event") {
  Simulation calm = make_run(kLaw, kLift);
  Simulation eventful = make_run(kLaw, kLift + event("at = 0.5\ncontroller = \"off\"\n"));
  calm.run_until(0.5);
  eventful.run_until(0.5);
  CHECK(calm.state_hash() == eventful.state_hash());
  calm.run_until(1.0);
  eventful.run_until(1.0);
  CHECK(calm.state_hash() != eventful.state_hash());
  CHECK(eventful.sensor("control.pitch.rate") == 0.0);
}

TEST_CASE("a yaw event turns what carries the hub at its rate") {
  std::string text = make_vanes("[control.turbine]\nyaw_joint = \"yaw\"\n",
                                event("at = 0.1\nyaw = { to = -0.3, rate = 0.5 }\n"));
  text += R"([support]
[[support.body]]
name = "nacelle"
kind = "rigid"
mass = 5.0
inertia = 2.0
[[support.joint]]
name = "yaw"
parent = "ground"
child = "nacelle"
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { constant = 0.0 }
[support.axle]
body = "nacelle"
)";
  Simulation simulation(parse_scenario(text, "vanes.toml"), {.executor = ExecutorKind::serial});
  simulation.run_until(0.4);
  // The course follows a demand one period later than the time of an even one.
  CHECK(simulation.sensor("support.yaw") == Approx(-0.5 * (0.3 - 0.1)).epsilon(1e-6));
  simulation.run_until(2.0);
  CHECK(simulation.sensor("support.yaw") == -0.3);
}

TEST_CASE("executors, and runs by steps or at once, give a run with events equal bits") {
  Simulation known = tell();
  known.run_until(1.0);
  for (const EventInRun& event : known.events()) CHECK(event.time);
  CHECK(*known.events()[1].time < 0.69);
  for (const ExecutorKind kind : {ExecutorKind::automatic, ExecutorKind::flow_graph}) {
    Simulation other = tell(kind, 2);
    while (other.time() < 0.3) other.step();
    int rows = 0;
    other.run_until(1.0, [&](double, std::span<const double>) { ++rows; });
    CHECK(rows == 140);
    CHECK(other.state_hash() == known.state_hash());
    CHECK(*other.events()[1].time == *known.events()[1].time);
  }
}

TEST_CASE("a run with events goes on from a saved state with the bits of the unbroken run") {
  Simulation unbroken = tell();
  unbroken.run_until(1.0);
  const double stop = *unbroken.events()[1].time;
  for (const double t : {0.0, stop - 0.01, stop, stop + 0.1, 0.7, 0.9}) {
    Simulation first = tell();
    first.run_until(t);
    const SavedState state = parse_checkpoint(make_checkpoint(first.save()), "c").state;
    Simulation second = tell();
    second.run_until(0.8);
    second.restore(state);
    CHECK(second.events()[1].time.has_value() == (t > stop + 1e-9));
    second.run_until(1.0);
    CHECK(second.state_hash() == unbroken.state_hash());
    Simulation third = tell();
    restore(third, state, courses(first));
    third.run_until(1.0);
    CHECK(third.state_hash() == unbroken.state_hash());
    Simulation copy = first.clone();
    first.run_until(0.9);
    copy.run_until(1.0);
    CHECK(copy.state_hash() == unbroken.state_hash());
  }
}

TEST_CASE("states whose events are at steps that were not made are refused") {
  Simulation simulation = tell();
  simulation.run_until(0.5);
  const SavedState good = simulation.save();
  const auto at = std::find(good.values.begin(), good.values.end(),
                            std::round(*simulation.events()[0].time / kStep));
  REQUIRE(at != good.values.end());
  for (const double value : {-2.0, 0.5, 1000.0}) {
    SavedState state = good;
    state.values[static_cast<std::size_t>(at - good.values.begin())] = value;
    CHECK(message_of([&] { simulation.restore(state); }) ==
          "the saved state has events at steps that it has not made");
  }
  simulation.restore(good);
}

TEST_CASE("a drive that the program sets is without torque once the generator is off") {
  Simulation simulation = make_run(kTurbine, event("at = 0.1\ngenerator = \"off\"\n"));
  simulation.run_until(0.2);
  simulation.set_drive(TorqueDrive{Curve(10.0)});
  CHECK(std::get<TorqueDrive>(courses(simulation).drive).torque.value(0.0) == 10.0);
  simulation.run_until(0.5);
  CHECK(simulation.sensor("hub.speed") == Approx(2.0).epsilon(1e-12));
}

TEST_CASE("the keys of events are written as they are read") {
  const Scenario scenario = make_machine(
      kLaw, event("name = \"a\"\nat = 1.5\ndelay = 0.25\nbrake = 3.0\nbrake_speed = 0.1\n") +
                event("when = \"hub.speed > 1.4\"\ngenerator = \"off\"\ncontroller = \"off\"\n"
                      "pitch = { to = 1.5, rate = 0.1, blades = [1, 3] }\n"));
  const std::string json = scenario_to_json(scenario).dump();
  const Scenario again = parse_scenario(document_of(json), "again.toml");
  CHECK(scenario_to_json(again).dump() == json);
  REQUIRE(again.space->events.size() == 2);
  CHECK(again.space->events[1].pitch->blades == std::vector<int>{1, 3});
}

TEST_CASE("events that cannot be are refused, with their place") {
  const auto refusal = [](const std::string& keys, const std::string& control = kLaw) {
    const std::string message = message_of([&] { make_machine(control, event(keys)); });
    return message.substr(message.find("event.1"));
  };
  CHECK(refusal("brake = 1.0\n") == "event.1.at: is missing, expected a time (s), or when");
  CHECK(refusal("at = 1.0\nwhen = \"hub.speed > 1\"\nbrake = 1.0\n") ==
        "event.1.when: given along with at, expected only one of them");
  for (const char* when : {"hub.speed", "hub.speed > ", "> 3", "hub.speed > 3 rad", "a > b > 1"})
    CHECK(refusal("when = \"" + std::string(when) + "\"\nbrake = 1.0\n") ==
          "event.1.when: is \"" + std::string(when) +
              "\", expected a sensor, > or <, and a number, as \"hub.speed > 1.4\"");
  CHECK(refusal("at = 1.0\n") ==
        "event.1: does nothing, expected generator, brake, controller, pitch or yaw");
  CHECK(refusal("at = 1.0\ngenerator = \"on\"\n").starts_with("event.1.generator: is \"on\""));
  CHECK(
      refusal("at = 1.0\npitch = { to = 1.0 }\n") ==
      "event.1.pitch.rate: is missing, expected the rate at which the angle goes to `to` (rad/s)");
  CHECK(refusal("at = 1.0\npitch = { rate = 1.0 }\n") ==
        "event.1.pitch.to: is missing, expected the angle that is reached at the rate (rad)");
  CHECK(refusal("at = 1.0\npitch = { blades = [4] }\n") ==
        "event.1.pitch.blades: is 4, expected 1 to 3");
  CHECK(refusal("at = 1.0\npitch = { blades = [1, 1] }\n") ==
        "event.1.pitch.blades: is 1 twice, expected each blade once");
  CHECK(refusal("at = 1.0\npitch = { blades = [1.5] }\n")
            .ends_with("expected an array of numbers of blades, from 1"));
  CHECK(refusal("at = 1.0\npitch = {}\n", "") ==
        "event.1.pitch: turns blades, but no controller does, expected [control.turbine] with "
        "their joint");
  CHECK(refusal("at = 1.0\ncontroller = \"off\"\n", kTurbine) ==
        "event.1.controller: is \"off\", but there is none, expected one in [control]");
  CHECK(refusal("at = 1.0\nyaw = {}\n") ==
        "event.1.yaw: turns a yaw joint, but there is none, expected yaw_joint in [control]");
  const auto of_drive = [](const std::string& drive) {
    const std::string message =
        message_of([&] { with_drive(drive, event("at = 1.0\ngenerator = \"off\"\n")); });
    return message.substr(message.find("event.1"));
  };
  CHECK(of_drive("kind = \"constant\"\nspeed = 2.0\n#")
            .starts_with("event.1.generator: acts on the torque of the drive, but hub.drive.kind "
                         "is \"constant\""));
  const std::string twice = event("name = \"a\"\nat = 1.0\nbrake = 1.0\n");
  CHECK(message_of([&] {
          make_machine("", twice + twice);
        }).ends_with("event.2.name: is \"a\" as another one, expected each name once"));
}

TEST_CASE("traces and measurements of nodes meet events as runs do, to the bit") {
  Simulation run = tell();
  run.run_until(1e9);
  for (const int window : {1, 4}) {
    Simulation traced(make_story(),
                      {.executor = ExecutorKind::flow_graph, .threads = {2, 1}, .window = window});
    StepTrace trace = traced.trace(traced.planned_steps() / 3);
    const std::int64_t first = traced.steps();
    trace.append(traced.trace(traced.planned_steps() - first));
    CHECK(first > 0);
    CHECK(traced.state_hash() == run.state_hash());
    CHECK(std::ssize(trace.steps) == traced.planned_steps());
    CHECK(traced.events().size() == run.events().size());
  }
  Simulation measured = tell(ExecutorKind::automatic, 2);
  open_window(measured);
  measure_nodes(measured, measured.planned_steps() - measured.steps());
  CHECK(measured.state_hash() == run.state_hash());
}

TEST_CASE("what cannot go along with events says so") {
  CHECK(message_of([] {
          make_run("", event("when = \"hub.spee > 1\"\nbrake = 1.0\n"));
        }).starts_with("event.1.when: the sensor"));
  CHECK(message_of([] { make_run(kTurbine, "", std::make_shared<Holder>()); }) ==
        "a controller is given, but the scenario has no [control.program]");
}
