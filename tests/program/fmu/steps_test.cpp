// Steps of an FMU have the bits of a simulation, also from a state on that it goes back to, and
// beside other instances.

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "tests/contains.h"
#include "tests/program/fmu/go_on.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/unpacked_fmu.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

TEST_CASE("an FMU has the bits of a simulation, from the start to beyond the scenario's end") {
  struct Case {
    std::string text;
    Overrides overrides;
  };
  for (const Case& each :
       {Case{kPitchedRotor, {}}, Case{kDrivenRotor, {}}, Case{kBlownRotor, {}},
        Case{kDrivenRotor, {"integration.step=0.0173"}},  // shortened to divide the duration
        Case{kDrivenRotor,
             {"integration.step=2e-4", "integration.duration=0.0401", "integration.method=rk4"}},
        Case{kDrivenRotor,
             {"initial.state=equilibrium", "hub.drive={kind=\"constant\",speed=2}"}}}) {
    const UnpackedFmu unpacked(each.text, {}, {}, each.overrides);
    const LoadedFmu fmu(unpacked.folder());
    FmuInstance instance(fmu);
    REQUIRE(instance.handle());
    Simulation simulation = simulate(each.text, each.overrides);
    REQUIRE(fmu.outputs() == simulation.sensor_names());
    const double step = 5 * simulation.step_size();
    CHECK(instance.initialize() == kOk);
    for (int k = 0; k <= 20; ++k) {
      simulation.run_until(k * step);
      CHECK(instance.get({"time"})[0] == simulation.time());
      CHECK(instance.outputs() == values_of(simulation));
      CHECK(instance.step(k * step, step) == kOk);
      CHECK(instance.reached == k * step + step);
    }
    Overrides longer = each.overrides;
    longer.push_back("integration.duration=" +
                     std::to_string(4.0 * simulation.scenario().integration.duration));
    longer.push_back("integration.step=" + fmu.attribute("fixedInternalStepSize"));
    Simulation beyond = simulate(each.text, longer);
    const double end = 2.0 * simulation.scenario().integration.duration;
    double t = 21 * step;
    while (t < end) {
      CHECK(instance.step(t, step) == kOk);
      t += step;
    }
    beyond.run_until(t);
    CHECK(beyond.steps() > simulation.planned_steps());
    CHECK(instance.outputs() == values_of(beyond));
    CHECK(instance.errors() == 0);
  }
}

TEST_CASE(
    "an instance that goes back to a state has the same bits again, whatever was set meanwhile") {
  for (const std::string& text : {kPitchedRotor, kDrivenRotor}) {
    const UnpackedFmu unpacked(text);
    const LoadedFmu fmu(unpacked.folder());
    FmuInstance instance(fmu);
    REQUIRE(instance.handle());
    void* start = nullptr;
    CHECK(instance.get_state(&start) == kOk);
    CHECK(instance.initialize(10.0) == kOk);
    const std::vector<double> given(fmu.inputs().size(), 0.7), other(fmu.inputs().size(), -0.3);
    const auto before = go_on(instance, 10.0, 0.02, 3);
    CHECK(instance.set(fmu.inputs(), given) == kOk);
    const auto first = go_on(instance, 10.06, 0.02, 3);
    void* state = nullptr;
    CHECK(instance.get_state(&state) == kOk);
    const auto second = go_on(instance, 10.12, 0.02, 3);
    CHECK(instance.set(fmu.inputs(), other) == kOk);
    const auto third = go_on(instance, 10.18, 0.04, 2);
    for (int repeat = 0; repeat < 2; ++repeat) {
      CHECK(instance.set_state(state) == kOk);
      CHECK(instance.get({"time"})[0] == doctest::Approx(10.12).epsilon(1e-12));
      CHECK(instance.get(fmu.inputs()) == given);
      CHECK(instance.outputs() == first.back());
      CHECK(go_on(instance, 10.12, 0.02, 3) == second);
      CHECK(instance.set(fmu.inputs(), other) == kOk);
      CHECK(go_on(instance, 10.18, 0.04, 2) == third);
    }
    // By way of bytes, in an instance that has not begun.
    const std::vector<std::uint8_t> bytes = instance.serialize(state);
    FmuInstance later(fmu);
    void* read = nullptr;
    CHECK(later.deserialize(bytes, &read) == kOk);
    CHECK(later.set_state(read) == kOk);
    CHECK(go_on(later, 10.12, 0.02, 3) == second);
    // From the start again.
    CHECK(instance.call("fmi3Reset") == kOk);
    CHECK(instance.initialize(10.0) == kOk);
    CHECK(go_on(instance, 10.0, 0.02, 3) == before);
    CHECK(instance.set_state(start) == kOk);
    CHECK(instance.initialize(0.0) == kOk);
    CHECK(instance.step(0.0, 0.02) == kOk);
    CHECK(instance.outputs() == before.front());
    CHECK(instance.free_state(&state) == kOk);
    CHECK(!state);
    CHECK(instance.errors() == 0);
  }
}

TEST_CASE("instances in one process do not know each other") {
  const UnpackedFmu unpacked(kPitchedRotor), other_unpacked(kDrivenRotor);
  const LoadedFmu fmu(unpacked.folder()), other_fmu(other_unpacked.folder());
  FmuInstance alone(fmu);
  CHECK(alone.initialize() == kOk);
  const auto expected = go_on(alone, 0.0, 0.02, 8);
  FmuInstance one(fmu), two(fmu), other(other_fmu);
  CHECK(one.initialize() == kOk);
  CHECK(two.initialize() == kOk);
  CHECK(other.initialize() == kOk);
  CHECK(two.set({"drive.torque", "load.gust"}, {-5.0, 3.0}) == kOk);
  for (int k = 0; k < 8; ++k) {
    CHECK(two.step(0.02 * k, 0.02) == kOk);
    CHECK(one.step(0.02 * k, 0.02) == kOk);
    CHECK(other.step(0.02 * k, 0.02) == kOk);
    CHECK(one.outputs() == expected[static_cast<std::size_t>(k)]);
  }
  CHECK(two.outputs() != expected.back());
}

TEST_CASE("a model that diverges is an error with a sentence, and the instance can go back") {
  // A load that grows without end.
  const UnpackedFmu unpacked(kPitchedRotor, {"load.gust"}, {"hub.speed"},
                             {"limits.deflection=0.1"});
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  const auto expected = go_on(instance, 0.0, 0.02, 2);
  void* state = nullptr;
  CHECK(instance.get_state(&state) == kOk);
  CHECK(instance.set({"load.gust"}, {1e9}) == kOk);
  const std::size_t before = instance.messages.size();
  CHECK(instance.step(0.04, 0.2) == kError);
  REQUIRE(instance.messages.size() > before);
  CHECK(instance.messages.back().status == kError);
  CHECK(instance.messages.back().category == "logStatusError");
  CHECK(contains(instance.last(), "fmi3DoStep: "));
  CHECK(contains(instance.last(), "step"));
  // From then on all is refused, but what takes the instance elsewhere.
  std::vector<double> values(1);
  CHECK(instance.get({fmu.reference("hub.speed")}, values) == kError);
  CHECK(instance.step(0.04, 0.02) == kError);
  CHECK(contains(instance.last(), "failed"));
  void* none = nullptr;
  CHECK(instance.get_state(&none) == kError);
  CHECK(instance.set({"load.gust"}, {1.0}) == kError);
  CHECK(instance.set_state(state) == kOk);
  const auto again = go_on(instance, 0.04, 0.02, 1);
  FmuInstance other(fmu);
  CHECK(other.initialize() == kOk);
  CHECK(go_on(other, 0.0, 0.02, 3).back() == again.back());
  CHECK(instance.call("fmi3Reset") == kOk);
  CHECK(instance.initialize() == kOk);
  CHECK(go_on(instance, 0.0, 0.02, 2) == expected);
}
