// A model whose subsystems are shared out over processes, here threads of the test: every process
// ends in the bits of one alone, and says the same of a failure.

#include "engine/step/sharing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/simulation.h"
#include "engine/simulation/simulation_core.h"
#include "graph/declaration_check.h"
#include "models/error.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/loop_models.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/engine/step/thread_exchange.h"
#include "tests/shipped.h"

using namespace spoke;
using test::on_ranks;
using test::ThreadExchange;

namespace {

constexpr int kSteps = 70;  // more than a window has

/// Process number `rank_` of some that say nothing.
class SilentExchange : public Exchange {
 public:
  SilentExchange(int rank, int count) : rank_(rank), count_(count) {}
  int rank() const override { return rank_; }
  int count() const override { return count_; }
  void share(std::span<std::byte>, std::span<const std::size_t>) noexcept override {}

 private:
  int rank_, count_;
};

/// Results of a run.
struct Shown {
  std::uint64_t hash = 0;
  std::int64_t steps = 0, evaluations = 0;
  std::vector<double> sensors;  ///< of all steps
  std::vector<double> state;
  std::string error;
  friend bool operator==(const Shown&, const Shown&) = default;
};

Shown run(const Scenario& scenario, const SimulationOptions& options) {
  Simulation simulation(scenario, options);
  Shown shown;
  try {
    simulation.run_until(0.3 * scenario.integration.duration);  // unobserved
    simulation.run_until(scenario.integration.duration,
                         [&](double t, std::span<const double> values) {
                           shown.sensors.push_back(t);
                           shown.sensors.insert(shown.sensors.end(), values.begin(), values.end());
                         });
    shown.state = simulation.save().values;
    for (const double value : simulation.sensor_values()) shown.sensors.push_back(value);
  } catch (const DivergenceError& error) {
    shown.error = error.what();
  }
  shown.hash = simulation.state_hash();
  shown.steps = simulation.steps();
  shown.evaluations = simulation.evaluations();
  return shown;
}

std::vector<Shown> run_shared(const Scenario& scenario, SimulationOptions options, int count) {
  std::vector<Shown> shown(static_cast<std::size_t>(count));
  on_ranks(count, [&, options](ThreadExchange& exchange) mutable {
    SimulationOptions own = options;
    own.exchange = &exchange;
    // Processes need not run their graphs alike.
    if (exchange.rank() == 1) {
      own.executor = ExecutorKind::flow_graph;
      own.threads = 2;
    }
    shown[static_cast<std::size_t>(exchange.rank())] = run(scenario, own);
  });
  return shown;
}

Scenario read(const std::string& file, const Overrides& overrides) {
  Scenario scenario = test::read_shipped(file, overrides);
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// Five blades that do not move alike, by a drive that prescribes their motion, or by a torque.
Scenario make_rotor(bool is_driven) {
  Scenario scenario = read("wu_haug_rotor", {"blade.count=5", "blade.bodies=3"});
  scenario.rotor.gravity = Position{0.0, -0.5};
  scenario.rotor.blades[1].bodies = 1;
  if (!is_driven) scenario.rotor.hub.drive = TorqueDrive{Curve(20.0), 0.05};
  return scenario;
}

/// Trees of two subsystems, and two of trees of their own.
Scenario make_forests() {
  std::string second = test::kForest;
  second.replace(second.find("\"forest\""), 8, "\"other\"");
  Scenario scenario = test::make_scenario(
      test::make_text(test::kTurnedHub, test::kForest + test::kMotors + second + test::kTree), 2e-3,
      1.0, IntegrationMethod::generalized_alpha);
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// Blades and a tree on a tower, whose loads and joints all processes need.
Scenario make_tower(const std::string& hub) {
  const std::string sensor =
      "[[sensor]]\nname = \"axle\"\nquantity = \"joint_reaction\"\nsubsystem = \"support\"\n"
      "body = \"hub\"\n[[sensor]]\nquantity = \"acceleration\"\nframe = \"inertial\"\n";
  Scenario scenario = test::make_scenario(
      test::make_text(hub, test::kBooms + test::kHinges + test::kMotors + test::kTower,
                      test::kGravity + sensor),
      2e-3, 1.0, IntegrationMethod::generalized_alpha);
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// Blades whose pitch is under control, beside other trees.
Scenario make_controlled(const std::string& hub) {
  Scenario scenario = test::make_scenario(
      test::make_text(hub, test::kBooms + test::kControlledPitch + test::kMotors + test::kForest),
      2e-3, 1.0, IntegrationMethod::generalized_alpha);
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

struct Case {
  const char* name;
  Scenario scenario;
};
/// Those in space without what an explicit method finds stiff.
std::vector<Case> all_cases() {
  Scenario flying = make_rotor(false);
  flying.rotor.hub.support = HubSupport::free;
  flying.rotor.hub.mass = 50.0;
  return {{"driven", make_rotor(true)},
          {"turned", make_rotor(false)},
          {"free in the plane", flying},
          {"driven in space", read("articulated_rotor", {"damping.stiffness_factor=0"})},
          {"free in space", read("satellite_booms", {"blade.sections.flap_inertia=0.001",
                                                     "blade.sections.lag_inertia=0.001"})},
          {"forests on a hub that a torque turns", make_forests()},
          {"controlled, driven", make_controlled(test::kDrivenHub)},
          {"controlled, turned", make_controlled(test::kTurnedHub)},
          {"driven on a tower", make_tower(test::kDrivenHub)},
          {"turned on a tower", make_tower(test::kTurnedHub)}};
}

/// Four blades that a swashplate pitches by links, on a hub that turns as prescribed or by a
/// torque.
Scenario make_linked(const std::string& hub) {
  Scenario scenario = test::make_pitching(hub, 4);
  spatial::MountMotion shaken;
  shaken.translation =
      spatial::VectorHarmonic{.amplitude = spatial::Vector(0.0, 0.0, 0.02), .frequency = 9.0};
  shaken.rotation =
      spatial::VectorHarmonic{.amplitude = spatial::Vector(0.0, 0.1, 0.0), .frequency = 7.0};
  scenario.space->anchors[0].motion = shaken;
  for (const SensorQuantity quantity :
       {SensorQuantity::loop_reaction, SensorQuantity::loop_opening})
    scenario.sensors.push_back(
        test::loop_sensor(quantity, "", scenario.space->subsystems[3].name, "link"));
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// Trees of solids on a hub that turns as prescribed or by itself.
Scenario make_solids(bool is_driven, spatial::SolidCoordinates coordinates) {
  Scenario scenario;
  scenario.space = test::make_solid_trees(HubSupport::axle, coordinates);
  for (spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (spatial::Body& body : subsystem.bodies)
      if (auto* solid = std::get_if<spatial::SolidBody>(&body.shape))
        if (solid->coordinates == spatial::SolidCoordinates::nodal) solid->modes.reset();
  if (is_driven) scenario.space->hub.drive = ConstantSpeed{2.0};
  const auto add = [&](SensorQuantity quantity, const char* interface) {
    Sensor& sensor = scenario.sensors.emplace_back();
    sensor.quantity = quantity;
    sensor.subsystem = "pair";
    sensor.body = "arm";
    sensor.interface = interface;
  };
  add(SensorQuantity::displacement, "tip");
  add(SensorQuantity::interface_force, "root");
  add(SensorQuantity::von_mises, "");
  scenario.integration.step = 5e-4;
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// Takes steps beyond the stability limit of the method.
Scenario make_diverging(Scenario scenario) {
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.step *= 3.0;
  scenario.integration.duration *= 3.0;
  return scenario;
}

std::string refusal(const Scenario& scenario, const SimulationOptions& options,
                    const Loads& loads = {}) {
  try {
    const Simulation simulation(scenario, options, loads);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("subsystems are shared out in neighbours of about equal weight, none left without") {
  using Shares = std::vector<int>;
  CHECK(share_out(std::vector<double>{1, 1, 1, 1, 1, 1}, 3) == Shares{0, 2, 4, 6});
  CHECK(share_out(std::vector<double>{1, 1, 1}, 1) == Shares{0, 3});
  CHECK(share_out(std::vector<double>{9, 1, 1, 1}, 2) == Shares{0, 1, 4});
  CHECK(share_out(std::vector<double>{1, 1, 1, 90}, 3) == Shares{0, 2, 3, 4});
  CHECK(share_out(std::vector<double>{90, 1, 1, 1}, 3) == Shares{0, 1, 2, 4});
}

TEST_CASE("processes that share a model all have the bits of one alone") {
  for (const Case& which : all_cases())
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
      for (const Formulation formulation : {Formulation::structured, Formulation::subsystem}) {
        Scenario scenario = which.scenario;
        scenario.integration.method = method;
        if (method == IntegrationMethod::rk4) {
          scenario.integration.step = 1e-7;
          scenario.integration.duration = kSteps * scenario.integration.step;
        }
        const SimulationOptions options{formulation, ExecutorKind::serial, 1};
        const Shown expected = run(scenario, options);
        CHECK(expected.error == "");
        CHECK(expected.steps == kSteps);
        for (const int count : {2, 4}) {
          CAPTURE(which.name);
          CAPTURE(name_of(formulation));
          CAPTURE(count);
          for (const Shown& shown : run_shared(scenario, options, count)) CHECK(shown == expected);
        }
      }
}

TEST_CASE("processes that share a model with solids all have the bits of one alone") {
  for (const bool is_driven : {true, false})
    for (const auto& [coordinates, formulation] :
         {std::pair(spatial::SolidCoordinates::reduced, Formulation::structured),
          std::pair(spatial::SolidCoordinates::reduced, Formulation::subsystem),
          std::pair(spatial::SolidCoordinates::nodal, Formulation::structured)}) {
      const Scenario scenario = make_solids(is_driven, coordinates);
      const SimulationOptions options{formulation, ExecutorKind::serial, 1};
      const Shown expected = run(scenario, options);
      CHECK(expected.error == "");
      CHECK(expected.steps == kSteps);
      for (const Shown& shown : run_shared(scenario, options, 2)) CHECK(shown == expected);
    }
}

TEST_CASE("processes that share a model with loops all have the bits of one alone") {
  for (const char* hub : {"drive = { kind = \"constant\", speed = 5.0 }",
                          "mass = 3.0\ninertia = 0.8\ndrive = { kind = \"torque\", torque = 3.0, "
                          "initial_speed = 4.0 }"})
    for (const Formulation formulation : {Formulation::structured, Formulation::subsystem}) {
      const Scenario scenario = make_linked(hub);
      const SimulationOptions options{formulation, ExecutorKind::serial, 1};
      const Shown expected = run(scenario, options);
      CHECK(expected.error == "");
      CHECK(expected.steps == kSteps);
      for (const int count : {2, 4}) {
        CAPTURE(hub);
        CAPTURE(name_of(formulation));
        CAPTURE(count);
        for (const Shown& shown : run_shared(scenario, options, count)) CHECK(shown == expected);
      }
    }
}

TEST_CASE("windows that are asked for, and the executor auto, change no bits of a shared model") {
  for (const bool is_driven : {true, false}) {
    const Scenario scenario = make_rotor(is_driven);
    const Shown expected = run(scenario, {Formulation::structured, ExecutorKind::serial, 1});
    for (const int window : {1, 7})
      for (const ExecutorKind kind : {ExecutorKind::serial, ExecutorKind::automatic}) {
        const int threads = kind == ExecutorKind::serial ? 1 : 2;
        const SimulationOptions options{Formulation::structured, kind, threads, window};
        for (const Shown& shown : run_shared(scenario, options, 3)) CHECK(shown == expected);
      }
  }
}

TEST_CASE("processes that share a model say the same where it diverges") {
  for (const Case& which : all_cases()) {
    CAPTURE(which.name);
    const Scenario scenario = make_diverging(which.scenario);
    const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
    const Shown expected = run(scenario, options);
    CHECK(!expected.error.empty());
    for (const Shown& shown : run_shared(scenario, options, 3)) CHECK(shown == expected);
  }
}

TEST_CASE("one process that asks to stop stops all that share a model at the same step") {
  const Scenario scenario = make_rotor(true);
  const Shown expected = run(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  std::vector<std::int64_t> stopped(3);
  std::vector<std::uint64_t> hashes(3);
  on_ranks(3, [&](ThreadExchange& exchange) {
    Simulation simulation(scenario,
                          {.executor = ExecutorKind::serial, .window = 5, .exchange = &exchange});
    simulation.run_until(scenario.integration.duration, [&](double, std::span<const double>) {
      if (exchange.rank() == 0) simulation.stop();
    });
    const auto rank = static_cast<std::size_t>(exchange.rank());
    stopped[rank] = simulation.steps();
    while (!simulation.done()) simulation.step();
    hashes[rank] = simulation.state_hash();
  });
  for (const std::int64_t steps : stopped) {
    CHECK(steps == stopped[0]);
    CHECK(steps < kSteps / 2);
  }
  for (const std::uint64_t hash : hashes) CHECK(hash == expected.hash);
}

TEST_CASE("an observer's exception leaves processes that share a model at its step") {
  for (const bool is_driven : {true, false}) {
    const Scenario scenario = make_rotor(is_driven);
    const auto throw_at_10 = [](Simulation& simulation) {
      try {
        simulation.run_until(1e9, [](double t, std::span<const double>) {
          if (t > 0.0499) throw Error(ErrorCode::internal, "enough");
        });
      } catch (const Error&) {
      }
      return simulation.save().values;
    };
    Simulation alone(scenario, {.executor = ExecutorKind::serial});
    const std::vector<double> expected = throw_at_10(alone);
    CHECK(alone.steps() == 10);
    on_ranks(2, [&](ThreadExchange& exchange) {
      Simulation simulation(scenario, {.executor = ExecutorKind::serial, .exchange = &exchange});
      CHECK(throw_at_10(simulation) == expected);
    });
  }
}

TEST_CASE("what processes cannot share is refused") {
  const Scenario scenario = make_rotor(true);
  SilentExchange exchange(0, 6), two(1, 2);
  CHECK(refusal(scenario, {.exchange = &exchange}) ==
        "6 processes simulate the model together: it has 5 subsystems, expected at most so many "
        "processes");
  CHECK(refusal(scenario, {.formulation = Formulation::augmented, .exchange = &two}) ==
        "2 processes simulate the model together: the formulation is augmented, expected "
        "structured or subsystem");
  const Loads loads{make_load("own", {{0, 0, 1.0}}, [](auto...) {})};
  CHECK(refusal(scenario, {.exchange = &two}, loads) ==
        "2 processes simulate the model together: expected no loads of the program's");
  Scenario helicopter = read("helicopter_on_gear", {});
  helicopter.space->anchors.push_back({.name = "plate", .frame = Anchor::Frame::axle});
  CHECK(refusal(helicopter, {.exchange = &two}) ==
        "2 processes simulate the model together: anchor \"plate\" stands beside the axle, whose "
        "wrench takes the forces on it from all blades, of which each process has its own; "
        "expected one process");
  Simulation simulation(scenario, {.exchange = &two});
  CHECK_THROWS_WITH_AS(simulation.trace(1),
                       "a trace: several processes simulate the model together, expected one",
                       InputError);
  CHECK_THROWS_WITH_AS(simulation.clone(),
                       "2 processes simulate the model together: it cannot be cloned, expected one "
                       "process",
                       InputError);
}

TEST_CASE("nodes of a shared model keep to what they declare") {
  for (const Case& which : all_cases()) {
    CAPTURE(which.name);
    SilentExchange exchange(1, 3);
    const SimulationOptions options{.executor = ExecutorKind::serial, .exchange = &exchange};
    Simulation simulation(which.scenario, options);
    CHECK(simulation.run_graph().node_count() < simulation.step_graph().node_count());
    StepTable& table = core_of(simulation).model->context().table();
    table.window = {1, 1, true};
    for (StepProgress& progress : table.progress) progress.is_halted = false;
    for (const graph::DeclarationFault& fault : graph::check_declarations(simulation.run_graph()))
      FAIL_CHECK(fault.message);
  }
}
