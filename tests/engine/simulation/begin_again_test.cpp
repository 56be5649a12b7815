// Tests that a simulation that is begun again with another drive has the bits of one that is built
// with it.

#include <doctest/doctest.h>

#include <span>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/simulation/simulation_core.h"
#include "models/error.h"
#include "tests/shipped.h"

using namespace spoke;

namespace {

constexpr int kSteps = 40;

/// Results of a run.
struct Shown {
  std::vector<double> sensors;  ///< of all steps
  std::vector<double> state;
  std::string model, error;
  std::uint64_t hash = 0;
  std::int64_t steps = 0, evaluations = 0;
  friend bool operator==(const Shown&, const Shown&) = default;
};

Shown run(Simulation& simulation) {
  Shown shown;
  const auto observe = [&](double t, std::span<const double> values) {
    shown.sensors.push_back(t);
    shown.sensors.insert(shown.sensors.end(), values.begin(), values.end());
  };
  observe(simulation.time(), simulation.sensor_values());
  try {
    simulation.run_until(1e9, observe);
    const SavedState saved = simulation.save();
    shown.state = saved.values;
    shown.model = *saved.model;
  } catch (const DivergenceError& error) {
    shown.error = error.what();
  }
  shown.hash = simulation.state_hash();
  shown.steps = simulation.steps();
  shown.evaluations = simulation.evaluations();
  return shown;
}

Scenario read(const std::string& file, Overrides overrides, const std::string& drive) {
  overrides.push_back(drive);
  Scenario scenario = test::read_shipped(file, overrides);
  scenario.integration.duration = kSteps * scenario.integration.step;
  return scenario;
}

/// A model, and two values of its drive.
struct Case {
  std::string file;
  Overrides overrides;
  std::string first, second;
};

const SimulationOptions kSerial{.executor = ExecutorKind::serial, .threads = 1};

}  // namespace

TEST_CASE("a simulation begun again with another drive has the bits of one built with it") {
  const std::string turned = "hub.drive={kind=\"torque\", torque=20.0, initial_speed=";
  const std::vector<Case> cases = {
      {"wu_haug_rotor", {}, "hub.drive.speed=4", "hub.drive.speed=6"},
      {"wu_haug_rotor",
       {"integration.method=rk4", "integration.step=2e-5", "gravity.acceleration=[0, -9.81]"},
       "hub.drive.ramp=0.01",
       "hub.drive.ramp=0.02"},
      {"wu_haug_rotor", {"hub.inertia=5"}, turned + "0.5}", turned + "2.0}"},
      {"free_hub_satellite", {}, turned + "0.0}", turned + "1.0}"},
      {"articulated_rotor", {}, "hub.drive.speed=10", "hub.drive.speed=12"},
      {"satellite_booms",
       {},
       "hub.drive={kind=\"torque\", torque=20.0}",
       "hub.drive={kind=\"torque\", torque=-5.0}"}};
  for (const Case& which : cases) {
    CAPTURE(which.file);
    CAPTURE(which.second);
    const Scenario first = read(which.file, which.overrides, which.first);
    const Scenario second = read(which.file, which.overrides, which.second);
    Simulation built(second, kSerial), again(first, kSerial);
    const Shown expected = run(built);
    CHECK(expected.error == "");
    const std::vector<double> start = core_of(again).take_values(0);
    CHECK(run(again).sensors != expected.sensors);
    core_of(again).begin_again(second, start);
    CHECK(run(again) == expected);
    CHECK(again.warnings().size() == built.warnings().size());
    core_of(again).begin_again(first, start);
    core_of(again).begin_again(second, start);
    CHECK(run(again) == expected);
  }
}

TEST_CASE("a simulation can be begun again behind a divergence, and refuses a bad drive") {
  const Scenario good = read("wu_haug_rotor", {}, "hub.drive.speed=4");
  Scenario bad = good;
  bad.rotor.hub.drive = SpinUp{1e6, 1e-3};
  Simulation simulation(bad, kSerial), built(good, kSerial);
  const std::vector<double> start = core_of(simulation).take_values(0);
  CHECK(run(simulation).error != "");
  bad.rotor.hub.drive = SpinUp{1.0, -1.0};
  CHECK_THROWS_AS(core_of(simulation).begin_again(bad, start), InputError);
  core_of(simulation).begin_again(good, start);
  CHECK(run(simulation) == run(built));
}

TEST_CASE("what starts from an equilibrium may not be begun again, for it depends on the drive") {
  Scenario scenario = read("wu_haug_rotor", {}, "hub.drive.speed=4");
  CHECK(may_begin_again(scenario));
  scenario.initial.state = InitialState::equilibrium;
  CHECK_FALSE(may_begin_again(scenario));
}
