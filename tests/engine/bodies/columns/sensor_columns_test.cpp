// Tests that the scenario's sensors keep their bits, states and names.

#include "engine/bodies/columns/sensor_columns.h"

#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/load_rotors.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;

namespace {

using Quantity = SensorQuantity;

std::vector<Sensor> every_sensor() {
  std::vector<Sensor> sensors;
  for (int quantity = 0; quantity <= static_cast<int>(Quantity::kinetic_energy); ++quantity) {
    Sensor sensor;
    sensor.quantity = static_cast<Quantity>(quantity);
    sensors.push_back(sensor);
  }
  sensors[3].position = 0.7;
  sensors[4].joint = JointChoice::number(1);
  return sensors;
}

std::vector<std::vector<double>> rows_of(const Scenario& scenario, const SimulationOptions& options,
                                         const Loads& loads) {
  Simulation simulation(scenario, options, loads);
  std::vector<std::vector<double>> rows;
  simulation.run_until(scenario.integration.duration, [&](double, std::span<const double> values) {
    rows.emplace_back(values.begin(), values.end());
  });
  return rows;
}

}  // namespace

TEST_CASE("sensors have the same bits on all executors, in windows, and after a restore") {
  for (const bool is_free : {false, true})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      Scenario scenario = soft_scenario(method, 0.02);
      scenario.rotor.gravity = Position{0.0, -9.81};
      if (is_free) scenario.rotor.hub.support = HubSupport::free;
      scenario.sensors = every_sensor();
      const Loads loads{demanding_load(0)};
      const auto expected =
          rows_of(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1}, loads);
      REQUIRE(expected.size() == 100);
      for (const int window : {2, 7, 0})
        CHECK(rows_of(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, window},
                      loads) == expected);

      Simulation simulation(scenario, serial(Formulation::structured));
      for (int n = 0; n < 20; ++n) simulation.step();
      simulation.joint_reaction(0, 0);
      const SavedState state = simulation.save();
      const std::vector<double> values(simulation.sensor_values().begin(),
                                       simulation.sensor_values().end());
      Simulation other(scenario, serial(Formulation::structured));
      other.restore(state);
      CHECK(std::vector<double>(other.sensor_values().begin(), other.sensor_values().end()) ==
            values);
    }
}

TEST_CASE("a state goes on in a simulation with other sensors") {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.02);
  Simulation plain(scenario);
  plain.run_until(0.01);
  scenario.sensors = every_sensor();
  Simulation measured(scenario);
  measured.restore(plain.save());
  plain.run_until(0.02);
  measured.run_until(0.02);
  CHECK(measured.state_hash() == plain.state_hash());
}

TEST_CASE("the memory told has what sensors integrate over, once for bodies that are alike") {
  const auto extra_memory = [](bool is_tapered) {
    Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.02);
    Blade blade = scenario.rotor.blades[0];
    blade.bodies = 30;
    blade.elements = 5;
    if (is_tapered) {
      blade.density = blade.area = blade.second_moment = blade.youngs_modulus = 0.0;
      blade.sections = {{0.0, blade.length}, {1.0, 0.5}, {1e6, 5e5}, {1e3, 5e2}};
    }
    scenario.rotor.blades = {blade};
    const auto memory = [](const Scenario& asked) {
      return Simulation(asked, serial(Formulation::structured)).size().memory_bytes;
    };
    const std::size_t before = memory(scenario);
    scenario.sensors.resize(2);
    scenario.sensors[0].quantity = Quantity::momentum;
    scenario.sensors[1].quantity = Quantity::blade_momentum;
    return memory(scenario) - before;
  };
  constexpr std::size_t kPointers = 2 * 30 * sizeof(MassPoints), kBody = 5 * 4 * sizeof(MassPoint);
  CHECK(extra_memory(false) == kPointers + kBody);
  CHECK(extra_memory(true) == kPointers + 30 * kBody);
}

TEST_CASE("sensors that are none are refused when they are filled in code") {
  const auto message_of = [](const std::function<void(Sensor&)>& spoil) -> std::string {
    Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.02);
    scenario.sensors.resize(1);
    spoil(scenario.sensors[0]);
    try {
      Simulation simulation(scenario);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK(message_of([](Sensor&) {}) == "accepted");
  CHECK(message_of([](Sensor& s) { s.blade = BladeChoice::number(3); }) ==
        "sensor.1.blade: is 3, expected a whole number from 1 to 2");
  CHECK(message_of([](Sensor& s) { s.position = 2.5; }) ==
        "sensor.1.position: is 2.5, expected a number from 0 to 2 (m, from root to tip of the "
        "blade)");
  CHECK(message_of([](Sensor& s) { s.name = "a,b"; }) ==
        "sensor.1.name: is \"a,b\", expected letters, digits, \"_\", \"-\" and \".\", 1 to 64 of "
        "them");
  CHECK(message_of([](Sensor& s) { s.frame = SensorFrame::section; }) ==
        "sensor.1.frame: is \"section\", which does not belong to quantity \"displacement\"");
  CHECK(message_of([](Sensor& s) { s.quantity = Quantity::joint_reaction; }) ==
        "sensor.1.joint: is missing, expected a whole number from 1 to 2");
  for (const int number : {0, 3})
    CHECK(message_of([number](Sensor& s) {
            s.quantity = Quantity::joint_reaction;
            s.joint = JointChoice::number(number);
          }) ==
          "sensor.1.joint: is " + std::to_string(number) + ", expected a whole number from 1 to 2");
  // An index, which counts from 0, is no number of a joint.
  static_assert(!std::is_convertible_v<int, JointChoice>);
  static_assert(!std::is_assignable_v<std::optional<JointChoice>&, int>);
}
