// Tests that states are saved and restored: a run split anywhere goes on with the bits of the whole
// run.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/simulation/observations.h"
#include "models/error.h"
#include "tests/engine/rotors.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kSteps = 30;

/// Makes unequal blades on a hub that is prescribed, or else free and driven by a torque.
Scenario make_scenario(IntegrationMethod method, bool has_free_hub) {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.01);
  Rotor& rotor = scenario.rotor;
  rotor.blades[1].bodies = 3;
  rotor.blades[1].reference_frame = ReferenceFrame::chord;
  rotor.blades[2].geometric_stiffening = false;
  rotor.gravity = Position{0.0, -9.81};
  rotor.damping = {0.0, 1e-5};
  rotor.hub.inertia = 2.0;
  if (has_free_hub) {
    rotor.hub.support = HubSupport::free;
    rotor.hub.mass = 10.0;
    rotor.hub.drive = TorqueDrive{Curve(30.0), 0.5};
  }
  scenario.integration.method = method;
  if (method == IntegrationMethod::rk4) scenario.integration.step = 5e-5;
  scenario.integration.duration = kSteps * scenario.integration.step;
  Sensor sensor{SensorQuantity::acceleration, "end", BladeChoice::all(), {}, {},
                SensorFrame::inertial};
  scenario.sensors.push_back(sensor);
  sensor.quantity = SensorQuantity::section_force;
  sensor.name = "inside";
  sensor.position = 3.1;
  scenario.sensors.push_back(sensor);
  return scenario;
}

/// All that a run shows, by step.
struct Shown {
  std::vector<std::vector<double>> rows;
  std::uint64_t hash = 0;
  std::int64_t evaluations = 0;
};

StepObserver observer_of(Shown& shown) {
  return [&shown](double t, std::span<const double> sensors) {
    shown.rows.emplace_back(sensors.begin(), sensors.end());
    shown.rows.back().push_back(t);
  };
}

void run_steps(int steps, Simulation& simulation, Shown& shown) {
  simulation.run_until((static_cast<double>(simulation.steps()) + steps) * simulation.step_size(),
                       observer_of(shown));
  shown.hash = simulation.state_hash();
  shown.evaluations = simulation.evaluations();
}

Shown run_whole(const Scenario& scenario, Formulation formulation) {
  Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 1});
  Shown shown;
  run_steps(kSteps, simulation, shown);
  return shown;
}

/// Whether to compare an executor: those that are slow with more threads than processors are tested
/// less.
bool is_to_compare(ExecutorKind kind) {
  return kind != ExecutorKind::automatic && kind != ExecutorKind::serial &&
         kind != ExecutorKind::flow_graph;
}

void check_tail(const Shown& part, const Shown& whole) {
  CHECK(part.hash == whole.hash);
  CHECK(part.evaluations == whole.evaluations);
  REQUIRE(part.rows.size() <= whole.rows.size());
  const auto first = whole.rows.end() - static_cast<std::ptrdiff_t>(part.rows.size());
  CHECK(std::equal(part.rows.begin(), part.rows.end(), first));
}

/// Makes one linear body per blade, which fails beyond 3 rad/s.
Scenario failing_scenario() {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 4), 0.005);
  scenario.rotor.blades[1].geometric_stiffening = false;
  scenario.integration.duration = 12.0;
  return scenario;
}

}  // namespace

TEST_CASE("a run split anywhere goes on with the same bits on every executor and window") {
  for (const bool has_free_hub : {false, true})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
      for (const Formulation formulation : formulations()) {
        const Scenario scenario = make_scenario(method, has_free_hub);
        const Shown whole = run_whole(scenario, formulation);
        int split = 0;
        for (const ExecutorKind kind : graph::executor_kinds())
          for (const int window : {1, 7, 20}) {
            split = (split + 7) % kSteps;
            if (is_to_compare(kind) && split % 3 != 0) continue;
            CAPTURE(has_free_hub);
            CAPTURE(name_of(method));
            CAPTURE(name_of(formulation));
            CAPTURE(name_of(kind));
            CAPTURE(window);
            CAPTURE(split);
            Simulation first(scenario, {formulation, kind, 2, window});
            Shown ignored, rest;
            run_steps(split, first, ignored);
            const SavedState saved = first.save();
            CHECK(saved.steps == split);
            // Another simulation, which has gone elsewhere meanwhile, on another executor.
            Simulation second(scenario, {formulation, kind, 3, 21 - window});
            run_steps(kSteps - split / 2, second, ignored);
            second.restore(saved);
            CHECK(second.time() == first.time());
            CHECK(second.state_hash() == first.state_hash());
            run_steps(kSteps - split, second, rest);
            check_tail(rest, whole);
          }
      }
}

TEST_CASE("a state may be saved after every step and restored many times") {
  const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, false);
  const Shown whole = run_whole(scenario, Formulation::structured);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, 5});
  std::vector<SavedState> states{simulation.save()};
  while (!simulation.done()) {
    simulation.step();
    states.push_back(simulation.save());
  }
  CHECK(simulation.state_hash() == whole.hash);
  for (std::size_t n = states.size(); n-- > 0;) {
    simulation.restore(states[n]);
    CHECK(simulation.steps() == static_cast<std::int64_t>(n));
    Shown rest;
    run_steps(kSteps - static_cast<int>(n), simulation, rest);
    check_tail(rest, whole);
  }
}

TEST_CASE("a restored state has the sensors, hub and bodies that were saved") {
  for (const bool has_free_hub : {false, true})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      const Scenario scenario = make_scenario(method, has_free_hub);
      const SimulationOptions options{Formulation::subsystem, ExecutorKind::serial, 1};
      Simulation first(scenario, options), second(scenario, options);
      for (int n = 0; n < 11; ++n) first.step();
      second.restore(first.save());
      const auto sensors = first.sensor_values(), restored = second.sensor_values();
      CHECK(std::equal(sensors.begin(), sensors.end(), restored.begin(), restored.end()));
      CHECK(first.hub().acceleration == second.hub().acceleration);
      CHECK(first.body(1, 2).accelerations == second.body(1, 2).accelerations);
      CHECK(first.time() == second.time());
    }
}

TEST_CASE("a longer simulation goes on from the end of a shorter one") {
  Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, false);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
  const Shown whole = run_whole(scenario, Formulation::structured);
  scenario.integration.duration /= 2.0;
  scenario.title = "half of it";
  scenario.output.interval = 0.5;
  Simulation half(scenario, options);
  half.run_until(1.0);
  scenario.integration.duration *= 2.0;
  Simulation twice(scenario, options);
  twice.restore(half.save());
  Shown rest;
  run_steps(kSteps, twice, rest);
  check_tail(rest, whole);
}

TEST_CASE("after a divergence a state is restored, and nothing of the failure is left") {
  const Scenario scenario = failing_scenario();
  for (const Formulation formulation : formulations())
    for (const int window : {1, 20}) {
      Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, window});
      simulation.run_until(9.0);
      const SavedState saved = simulation.save();
      simulation.run_until(9.5);
      const std::uint64_t expected = simulation.state_hash();
      std::string first, second;
      for (std::string* message : {&first, &second}) {
        try {
          simulation.run_until(12.0);
        } catch (const DivergenceError& error) {
          *message = error.what();
        }
        CHECK_FALSE(message->empty());
        CHECK_THROWS_AS(simulation.save(), StateError);
        simulation.restore(saved);
        CHECK(simulation.time() == 9.0);
        simulation.run_until(9.5);
        CHECK(simulation.state_hash() == expected);
      }
      CHECK(first == second);
    }
}

TEST_CASE("what is not a number leaves no trace behind a restored state") {
  for (const bool has_free_hub : {false, true})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
      for (const Formulation formulation : formulations()) {
        const Scenario scenario = make_scenario(method, has_free_hub);
        const Shown whole = run_whole(scenario, formulation);
        Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 7});
        const SavedState saved = simulation.save();
        SavedState spoiled = saved;
        constexpr auto kObserved =
            static_cast<std::ptrdiff_t>(sizeof(Observations) / sizeof(double));
        // The values are finite, but their squares are not.
        std::fill(spoiled.values.begin(), spoiled.values.end() - kObserved, 1e200);
        simulation.restore(spoiled);
        CHECK_THROWS_AS(simulation.run_until(1.0), DivergenceError);
        simulation.restore(saved);
        Shown rest;
        run_steps(kSteps, simulation, rest);
        check_tail(rest, whole);
      }
}

TEST_CASE("after an exception of an observer a state is restored") {
  const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, false);
  const Shown whole = run_whole(scenario, Formulation::structured);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, 10});
  const SavedState saved = simulation.save();
  const StepObserver observe = [&](double, std::span<const double>) {
    throw std::runtime_error("enough");
  };
  CHECK_THROWS_WITH(simulation.run_until(1.0, observe), "enough");
  simulation.restore(saved);
  Shown rest;
  run_steps(kSteps, simulation, rest);
  check_tail(rest, whole);
}

TEST_CASE("an observer may stop a run, which leaves a state to save and to go on from") {
  for (const bool has_free_hub : {false, true})
    for (const ExecutorKind kind :
         {ExecutorKind::serial, ExecutorKind::flow_graph, ExecutorKind::automatic})
      for (const int window : {1, 3, 20}) {
        const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, has_free_hub);
        const Shown whole = run_whole(scenario, Formulation::structured);
        Simulation simulation(scenario, {Formulation::structured, kind, 2, window});
        Shown shown;
        int stops = 0;
        while (!simulation.done()) {
          const std::int64_t before = simulation.steps();
          simulation.run_until(1.0, [&, observe = observer_of(shown)](double t, auto sensors) {
            observe(t, sensors);
            if (simulation.steps() >= before + 4) simulation.stop();
          });
          if (simulation.done()) break;
          ++stops;
          CHECK(simulation.save().steps == simulation.steps());
          CHECK(shown.rows.size() == static_cast<std::size_t>(simulation.steps()));
        }
        CHECK(stops >= (window == 20 ? 0 : 2));
        shown.hash = simulation.state_hash();
        shown.evaluations = simulation.evaluations();
        check_tail(shown, whole);
        CHECK(shown.rows.size() == whole.rows.size());
      }
}

TEST_CASE("a request to stop that comes too late does not stop the next run") {
  Simulation simulation(make_scenario(IntegrationMethod::generalized_alpha, false));
  simulation.stop();
  simulation.run_until(0.1);
  CHECK(simulation.steps() == 10);
  simulation.run_until(0.2, [&](double, std::span<const double>) { simulation.stop(); });
  CHECK(simulation.steps() < 20);
  simulation.run_until(0.3);
  CHECK(simulation.done());
}

TEST_CASE("a state of another model is refused, with what differs") {
  const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, false);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
  const SavedState saved = Simulation(scenario, options).save();
  const auto refusal = [&](const Scenario& other,
                           Formulation formulation = Formulation::structured) {
    Simulation simulation(other, {formulation, ExecutorKind::serial, 1});
    const std::uint64_t before = simulation.state_hash();
    try {
      simulation.restore(saved);
    } catch (const InputError& error) {
      CHECK(simulation.state_hash() == before);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(refusal(scenario) == "accepted");
  Scenario other = scenario;
  other.rotor.blades[1].length = 7.5;
  CHECK(refusal(other) ==
        "the saved state is of another model: blades.2.length is 8.0 in the saved state and 7.5 "
        "here");
  other = scenario;
  other.integration.step /= 2.0;
  CHECK(refusal(other).find("integration.step is 0.01 in the saved state and 0.005 here") !=
        std::string::npos);
  other = scenario;
  other.rotor.blades.pop_back();
  CHECK(refusal(other).find("blades.3 is {") != std::string::npos);
  other = scenario;
  other.rotor.blades.push_back(other.rotor.blades[0]);
  CHECK(refusal(other).find("blades has not as many entries as here") != std::string::npos);
  CHECK(refusal(scenario, Formulation::subsystem)
            .find("formulation is \"structured\" in the saved state and \"subsystem\" here") !=
        std::string::npos);
}

TEST_CASE("a state is refused if loads between blades act on one of two simulations only") {
  const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, false);
  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
  const auto nothing = [](double, std::span<const MarkerMotion>, std::span<Wrench>) {};
  Simulation untied(scenario, options);
  Simulation tied(scenario, options, {make_load("none", {{0, 0, 1.0}, {1, 0, 1.0}}, nothing)});
  const SavedState saved = untied.save(), saved_tied = tied.save();
  constexpr const char* reason = "loads between blades act on one of the two simulations only";
  CHECK(test::message_of([&] { tied.restore(saved); }).find(reason) != std::string::npos);
  CHECK(test::message_of([&] { untied.restore(saved_tied); }).find(reason) != std::string::npos);
  tied.restore(saved_tied);
  untied.restore(saved);
}

TEST_CASE("a saved state that was tampered with is refused") {
  const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, false);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  CHECK_THROWS_WITH(simulation.restore({}), "the saved state is empty");
  SavedState saved = simulation.save();
  saved.values.pop_back();
  CHECK_THROWS_AS(simulation.restore(saved), InputError);
  saved = simulation.save();
  for (const std::string& text : {std::string("[["), std::string("{}"), std::string(1 << 20, '['),
                                  std::string("{\"blades\":") + std::string(1 << 20, '[') +
                                      std::string(1 << 20, ']') + "}"}) {
    saved.model = std::make_shared<const std::string>(text);
    CHECK_THROWS_AS(simulation.restore(saved), InputError);
  }
  saved = simulation.save();
  for (const std::int64_t steps : {std::int64_t{-1}, std::numeric_limits<std::int64_t>::max()}) {
    saved.steps = steps;
    CHECK_THROWS_AS(simulation.restore(saved), InputError);
  }
}

TEST_CASE("a saved state with a number that is not finite is refused, and nothing has changed") {
  const Scenario scenario = make_scenario(IntegrationMethod::generalized_alpha, true);
  const Shown whole = run_whole(scenario, Formulation::structured);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  const SavedState saved = simulation.save();
  const auto refusal = [&](const SavedState& state) {
    return test::message_of([&] { simulation.restore(state); });
  };
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    // A value of the hub, one in the middle, and one of the observations.
    for (const std::size_t place :
         {std::size_t{0}, saved.values.size() / 2, saved.values.size() - 1}) {
      SavedState spoiled = saved;
      spoiled.values[place] = bad;
      CHECK(refusal(spoiled) ==
            "value " + std::to_string(place + 1) + " of the saved state is not finite");
    }
    for (double SavedState::*const sum : {&SavedState::work, &SavedState::dissipated}) {
      SavedState spoiled = saved;
      spoiled.*sum = bad;
      CHECK(refusal(spoiled) == "the work of the saved state is not finite");
    }
  }
  Shown rest;
  run_steps(kSteps, simulation, rest);
  check_tail(rest, whole);
}
