// Controllers that a program gives: when they are called, what they keep, and that they change no
// bits by how a simulation is run.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/courses.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/control/vanes.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
using doctest::Approx;

namespace {

const std::string kProgram = "[control.program]\njoint = \"pitch\"\nperiod = 0.015\n";

/// Holds a speed by the pitch, with an integral; its torque grows with the azimuth.
class Governor : public Controller {
 public:
  void begin(const std::vector<std::string>& sensors) override {
    for (std::size_t i = 0; i < sensors.size(); ++i)
      if (sensors[i] == "hub.speed") speed_ = i;
  }
  void control(const ControlRecord& record, ControlCommands& commands) override {
    CHECK(std::abs(record.sensors[speed_]) == record.speed);
    times.push_back(record.time);
    integral_ += 0.3 * record.period * (record.speed - 1.9);
    for (std::size_t k = 0; k < commands.pitch.size(); ++k)
      commands.pitch[k] = integral_ + 0.01 * static_cast<double>(k);
    commands.torque = -0.5 * std::sin(record.azimuth);
    commands.brake = record.time > 0.7 ? 0.25 : 0.0;
  }
  std::vector<double> times;

 protected:
  std::size_t speed_ = 0;
  double integral_ = 0.0;
};

class SavedGovernor final : public Governor {
 public:
  std::optional<std::string> save() const override {
    return std::string(reinterpret_cast<const char*>(&integral_), sizeof integral_);
  }
  void restore(const std::string& saved) override {
    if (saved.size() != sizeof integral_) throw InputError("the state of no governor");
    std::memcpy(&integral_, saved.data(), saved.size());
  }
  std::shared_ptr<Controller> clone() const override {
    return std::make_shared<SavedGovernor>(*this);
  }
};

Scenario make_governed(const std::string& keys = kProgram + "brake_torque = 3.0\n") {
  return parse_scenario(make_vanes(keys, kLift), "vanes.toml");
}

Simulation govern(ExecutorKind executor = ExecutorKind::serial, int threads = 1) {
  return Simulation(make_governed(), {.executor = executor,
                                      .threads = {threads, 1},
                                      .controller = std::make_shared<SavedGovernor>()});
}

}  // namespace

TEST_CASE("a controller of the program's is called once at each of its samples") {
  const auto governor = std::make_shared<Governor>();
  Simulation simulation(make_governed(),
                        {.executor = ExecutorKind::serial, .controller = governor});
  CHECK(governor->times.empty());
  simulation.step();
  simulation.run_until(0.05);
  simulation.run_until(0.06);
  simulation.step();
  REQUIRE(governor->times.size() == 5);
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(governor->times[k] == Approx(0.015 * static_cast<double>(k)));
}

TEST_CASE("executors, and runs by steps or at once, give a controlled rotor equal bits") {
  Simulation known = govern();
  known.run_until(1.0);
  CHECK(std::abs(known.sensor("vane2.pitch")) > 0.01);
  for (const ExecutorKind kind : {ExecutorKind::automatic, ExecutorKind::flow_graph}) {
    Simulation other = govern(kind, 2);
    while (other.time() < 0.3) other.step();
    int rows = 0;
    other.run_until(1.0, [&](double, std::span<const double>) { ++rows; });
    CHECK(rows == 140);
    CHECK(other.state_hash() == known.state_hash());
  }
}

TEST_CASE("an observer stops a controlled run at the step that it is called for") {
  Simulation simulation = govern();
  simulation.run_until(1.0, [&](double t, std::span<const double>) {
    if (t > 0.0449) simulation.stop();  // at a sample
  });
  CHECK(simulation.steps() == 9);
}

TEST_CASE("a controlled rotor goes on from a saved state with the bits of the unbroken run") {
  Simulation unbroken = govern();
  unbroken.run_until(1.0);
  for (const double t : {0.0, 0.045, 0.05, 0.72}) {  // at samples and between, brake off and on
    Simulation first = govern();
    first.run_until(t);
    const SavedState state = parse_checkpoint(make_checkpoint(first.save()), "c").state;
    Simulation second = govern();
    second.run_until(0.8);
    second.restore(state);
    second.run_until(1.0);
    CHECK(second.state_hash() == unbroken.state_hash());
    Simulation third = govern();
    restore(third, state, courses(first));
    third.run_until(1.0);
    CHECK(third.state_hash() == unbroken.state_hash());
    Simulation copy = first.clone();
    first.run_until(0.9);
    copy.run_until(1.0);
    CHECK(copy.state_hash() == unbroken.state_hash());
  }
}

TEST_CASE("a controller that keeps data of its own is not saved, and one without a memory is") {
  Simulation simulation(make_governed(), {.controller = std::make_shared<Governor>()});
  CHECK(message_of([&] { simulation.save(); }) ==
        "the simulation cannot be saved: control.program keeps data of its own that it does not "
        "give, expected no checkpoints");
  CHECK(message_of([&] { simulation.clone(); }) ==
        "the simulation cannot be cloned: control.program gives no copy of itself");
  Simulation saved = govern();
  SavedState state = saved.save();
  state.control->memory = "short";
  CHECK(message_of([&] { saved.restore(state); }) == "the state of no governor");
  state.control->sampled = state.steps + 1;  // it cannot have been called yet
  CHECK(message_of([&] { saved.restore(state); }) ==
        "the saved state has nothing of control.program");
  state.control.reset();
  CHECK(message_of([&] { saved.restore(state); }) ==
        "the saved state has nothing of control.program");
}

TEST_CASE("what a controller throws leaves the run at the step before") {
  struct Thrower final : Governor {
    void control(const ControlRecord& record, ControlCommands& commands) override {
      if (record.time > 0.1) throw std::runtime_error("enough");
      Governor::control(record, commands);
    }
  };
  Simulation simulation(make_governed(), {.controller = std::make_shared<Thrower>()});
  CHECK_THROWS_WITH_AS(simulation.run_until(1.0), "enough", std::runtime_error);
  CHECK(simulation.steps() == 21);
}

TEST_CASE("a controller without its table, and a table without its controller, are refused") {
  CHECK(message_of([] { Simulation simulation(make_governed()); }) ==
        "control.program: the program gives no controller, expected one "
        "(SimulationOptions::controller, in Python controller=)");
  CHECK(message_of([] {
          Simulation simulation(make_governed(""), {.controller = std::make_shared<Governor>()});
        }) == "a controller is given, but the scenario has no [control.program]");
}

TEST_CASE("a rotor that turns the other way is controlled in its own sense") {
  const auto speed_at_end = [](const std::string& keys, double start) {
    Scenario scenario = parse_scenario(make_vanes(kProgram + keys), "vanes.toml");
    std::get<TorqueDrive>(scenario.space->hub.drive).initial_speed = start;
    Simulation simulation(scenario, {.executor = ExecutorKind::serial,
                                     .controller = std::make_shared<SavedGovernor>()});
    simulation.run_until(1.0);
    return simulation.sensor("hub.speed");
  };
  CHECK(speed_at_end("direction = -1\n", -2.0) == Approx(-speed_at_end("", 2.0)).epsilon(1e-12));
}

TEST_CASE("a controller is told the accelerations, the wind and the pitch as they are") {
  struct Listener final : Controller {
    void control(const ControlRecord& record, ControlCommands&) override { last = record; }
    ControlRecord last;
  };
  // The axis is level; its mount shakes it. Plates without drag, almost, are in the wind.
  std::string text = make_vanes(
      "[control.program]\njoint = \"pitch\"\ninitial = 0.2\n",
      "[gravity]\nacceleration = [0, 0, -10.0]\n[air]\n[wind]\nvelocity = [8.0, 6.0, 1.0]\n"
      "[hub.mount]\ntranslation = { amplitude = [1.0, 2.0, 3.0], frequency = 2.0 }\n");
  text.replace(text.find("inertia = [8.0"), 0, "axis = [1.0, 0.0, 0.0]\n");
  text.insert(text.find("mass = 0.5"), "drag = { area = [1e-12, 1e-12, 1e-12] }\n");
  const auto listener = std::make_shared<Listener>();
  Simulation simulation(parse_scenario(text, "vanes.toml"),
                        {.executor = ExecutorKind::serial, .controller = listener});
  simulation.run_until(0.5);
  const double t = listener->last.time, sine = std::sin(2.0 * t);
  CHECK(t == Approx(0.495));
  CHECK(listener->last.fore_aft == Approx(-4.0 * sine).epsilon(1e-6));
  CHECK(listener->last.side_side == Approx(-8.0 * sine).epsilon(1e-6));
  CHECK(listener->last.wind_speed == Approx(10.0));
  CHECK(listener->last.yaw_error == Approx(std::atan2(6.0, 8.0)));
  REQUIRE(listener->last.blades.size() == 3);
  CHECK(listener->last.blades[2].pitch == Approx(0.2));
}
