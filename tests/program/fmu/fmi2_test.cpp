// FMUs of FMI 2.0: the bits of a simulation, states, instances side by side, and calls that are not
// allowed.

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "tests/contains.h"
#include "tests/file_text.h"
#include "tests/program/fmu/go_on.h"
#include "tests/program/fmu/importer_2.h"
#include "tests/program/fmu/unpacked_fmu.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// What the standard's functions for co-simulation are called behind "fmi2".
const char* const kFunctions2 = R"(
CancelStep DeSerializeFMUstate DoStep EnterInitializationMode ExitInitializationMode FreeFMUstate
FreeInstance GetBoolean GetBooleanStatus GetDirectionalDerivative GetFMUstate GetInteger
GetIntegerStatus GetReal GetRealOutputDerivatives GetRealStatus GetStatus GetString GetStringStatus
GetTypesPlatform GetVersion Instantiate Reset SerializeFMUstate SerializedFMUstateSize SetBoolean
SetDebugLogging SetFMUstate SetInteger SetReal SetRealInputDerivatives SetString SetupExperiment
Terminate
)";

class Unpacked2 : public UnpackedFmu {
 public:
  explicit Unpacked2(const std::string& scenario, const std::vector<std::string>& inputs = {},
                     const Overrides& overrides = {})
      : UnpackedFmu(scenario, inputs, {}, overrides, fmu::FmiVersion::two) {}
};

}  // namespace

TEST_CASE("an FMU of FMI 2.0 has the bits of a simulation, and of the FMU of FMI 3.0") {
  for (const std::string& text : {kPitchedRotor, kDrivenRotor, kBlownRotor}) {
    const Unpacked2 unpacked(text);
    const UnpackedFmu other(text);
    const LoadedFmu fmu(unpacked.folder()), other_fmu(other.folder());
    CHECK(fmu.attribute("fmiVersion") == "2.0");
    CHECK(fmu.inputs() == other_fmu.inputs());
    Fmu2Instance instance(fmu);
    FmuInstance three(other_fmu);
    CAPTURE(instance.last());
    REQUIRE(instance.handle());
    Simulation simulation = simulate(text);
    REQUIRE(fmu.outputs() == simulation.sensor_names());
    const double step = 4 * simulation.step_size();
    CHECK(instance.initialize() == kOk);
    CHECK(three.initialize() == kOk);
    for (int k = 0; k < 5; ++k) {
      simulation.run_until(k * step);
      CHECK(instance.get({"time"})[0] == simulation.time());
      CHECK(instance.outputs() == values_of(simulation));
      CHECK(instance.step(k * step, step) == kOk);
      CHECK(three.step(k * step, step) == kOk);
    }
    const std::vector<double> given(fmu.inputs().size(), 0.7);
    CHECK(instance.set(fmu.inputs(), given) == kOk);
    CHECK(three.set(fmu.inputs(), given) == kOk);
    CHECK(instance.step(5 * step, step) == kOk);
    CHECK(three.step(5 * step, step) == kOk);
    CHECK(instance.outputs() == three.outputs());
    CHECK(instance.messages.empty());
  }
}

TEST_CASE("an instance of FMI 2.0 goes back to states, by way of bytes too, beside another one") {
  const Unpacked2 unpacked(kBlownRotor);
  const LoadedFmu fmu(unpacked.folder());
  Fmu2Instance instance(fmu), beside(fmu);
  const double step = 1.0 / 64;
  const std::vector<double> given(fmu.inputs().size(), 0.7), other(fmu.inputs().size(), -0.3);
  CHECK(instance.initialize(10.0) == kOk);
  CHECK(beside.initialize() == kOk);
  const auto before = go_on(instance, 10.0, step, 2);
  CHECK(instance.set(fmu.inputs(), given) == kOk);
  CHECK(beside.set(fmu.inputs(), other) == kOk);
  const auto first = go_on(instance, 10.0 + 2 * step, step, 2);
  void* state = nullptr;
  CHECK(instance.get_state(&state) == kOk);
  go_on(beside, 0.0, step, 2);
  const auto second = go_on(instance, 10.0 + 4 * step, step, 2);
  CHECK(instance.set(fmu.inputs(), other) == kOk);
  go_on(instance, 10.0 + 6 * step, 2 * step, 1);
  CHECK(instance.set_state(state) == kOk);
  CHECK(instance.get(fmu.inputs()) == given);
  CHECK(instance.outputs() == first.back());
  CHECK(go_on(instance, 10.0 + 4 * step, step, 2) == second);
  const std::vector<char> bytes = instance.serialize(state);
  void* read = nullptr;
  CHECK(beside.deserialize(bytes, &read) == kOk);
  CHECK(beside.set_state(read) == kOk);
  CHECK(go_on(beside, 10.0 + 4 * step, step, 2) == second);
  CHECK(instance.call("fmi2Reset") == kOk);
  CHECK(instance.initialize(10.0) == kOk);
  CHECK(go_on(instance, 10.0, step, 2) == before);
  CHECK(instance.free_state(&state) == kOk);
  CHECK(!state);
  CHECK(instance.messages.empty());
}

TEST_CASE("an error of the model is fmi2Error with its sentence, as a text and not as a format") {
  const Unpacked2 unpacked(kPitchedRotor, {"load.gust"}, {"limits.deflection=0.1"});
  const LoadedFmu fmu(unpacked.folder());
  Fmu2Instance instance(fmu);
  CHECK(instance.initialize() == kOk);
  void* state = nullptr;
  CHECK(instance.get_state(&state) == kOk);
  CHECK(instance.set({"load.gust"}, {1e9}) == kOk);
  CHECK(instance.step(0.0, 0.2) == kError);
  CHECK(instance.messages.back().status == kError);
  CHECK(instance.messages.back().category == "logStatusError");
  CHECK(contains(instance.last(), "fmi2DoStep: "));
  CHECK(instance.step(0.0, 0.2) == kError);
  CHECK(contains(instance.last(), "failed"));
  CHECK(instance.set_state(state) == kOk);
  CHECK(instance.step(0.0, 0.02) == kOk);
  const char* const percent = "100%s%n";
  using Logging = int(void*, int, std::size_t, const char* const*);
  CHECK(fmu.function<Logging>("fmi2SetDebugLogging")(instance.handle(), 1, 1, &percent) == kError);
  CHECK(contains(instance.last(), "no category \"100%s%n\""));
}

TEST_CASE("instances of FMI 2.0 are made of this FMU's guid and resources, for co-simulation") {
  const Unpacked2 unpacked(kPitchedRotor);
  const LoadedFmu fmu(unpacked.folder());
  const auto refused = [&](const Fmu2Instance& instance, const char* part) {
    CAPTURE(part);
    CAPTURE(instance.last());
    CHECK(!instance.handle());
    CHECK(contains(instance.last(), part));
  };
  const std::string folder = fmu.resources().string();
  refused(Fmu2Instance(fmu, "another guid"), "another guid");
  refused(Fmu2Instance(fmu, "", "file:///nowhere"), "/nowhere/spoke.toml");
  refused(Fmu2Instance(fmu, "", "https://example.org/resources"), "expected a URI");
  refused(Fmu2Instance(fmu, "", "file://elsewhere" + folder), "expected a URI");
  refused(Fmu2Instance(fmu, "", "", 0), "not for model exchange");
  // The ways in which importers write the location.
  for (const std::string start : {"file://", "file:", "file://localhost", ""})
    CHECK(Fmu2Instance(fmu, "", start + folder).handle());
  std::string escaped = folder;
  escaped.replace(escaped.rfind("resources"), 1, "%72");
  CHECK(Fmu2Instance(fmu, "", "file://" + escaped + "/").handle());
  using Make = void*(const char*, int, const char*, const char*, const Callbacks2*, int, int);
  const auto make = fmu.function<Make>("fmi2Instantiate");
  CHECK(!make(nullptr, 1, nullptr, nullptr, nullptr, 0, 0));
  CHECK(std::string(fmu.function<const char*()>("fmi2GetVersion")()) == "2.0");
  CHECK(std::string(fmu.function<const char*()>("fmi2GetTypesPlatform")()) == "default");
  std::istringstream names(kFunctions2);
  for (std::string name; names >> name;)
    CHECK_NOTHROW(fmu.function<void()>(("fmi2" + name).c_str()));
}

TEST_CASE("calls of FMI 2.0 out of order, and of what there is not, change nothing") {
  const Unpacked2 unpacked(kPitchedRotor);
  const LoadedFmu fmu(unpacked.folder());
  Fmu2Instance instance(fmu), plain(fmu);
  std::vector<double> values(1);
  const auto refused = [&](int status, const char* part) {
    CAPTURE(part);
    CAPTURE(instance.last());
    CHECK(status == kError);
    CHECK(contains(instance.last(), part));
  };
  refused(instance.step(0.0, 0.02), "instantiated");
  refused(instance.get({fmu.reference("hub.speed")}, values), "instantiated");
  refused(instance.set_up(std::nan("")), "finite");
  // An experiment that is not set up begins at 0.
  CHECK(instance.call("fmi2EnterInitializationMode") == kOk);
  refused(instance.set_up(0.0), "in initialization mode");
  CHECK(instance.call("fmi2ExitInitializationMode") == kOk);
  CHECK(plain.initialize() == kOk);
  refused(instance.step(0.0, 0.003), "multiple");
  refused(instance.step(0.02, 0.02), "communication point");
  refused(instance.set({"load.gust"}, {std::numeric_limits<double>::infinity()}), "load.gust");
  refused(instance.call("fmi2CancelStep"), "this FMU has no ");
  void* const handle = instance.handle();
  const unsigned reference = 1;
  const int order = 1;
  double value = 0.0;
  using Derive = int(void*, const unsigned*, std::size_t, const int*, double*);
  for (const char* name : {"fmi2SetRealInputDerivatives", "fmi2GetRealOutputDerivatives"})
    refused(fmu.function<Derive>(name)(handle, &reference, 1, &order, &value), "derivatives");
  using Any = int(void*, const unsigned*, std::size_t, void*);
  for (const std::string type : {"Integer", "Boolean", "String"})
    for (const std::string verb : {"fmi2Get", "fmi2Set"}) {
      const auto any = fmu.function<Any>((verb + type).c_str());
      CHECK(any(handle, nullptr, 0, nullptr) == kOk);
      refused(any(handle, &reference, 1, &value), "real numbers");
    }
  for (const std::string verb : {"fmi2Get", "fmi2Set"}) {
    const auto any = fmu.function<Any>((verb + "Real").c_str());
    CHECK(any(nullptr, &reference, 1, &value) == kError);
    CHECK(any(handle, nullptr, 1, &value) == kError);
    CHECK(any(handle, nullptr, 0, nullptr) == kOk);
  }
  // What is known of a step: the time up to which it has come, and that no simulation ends itself.
  CHECK(instance.step(0.0, 0.02) == kOk);
  CHECK(plain.step(0.0, 0.02) == kOk);
  using Ask = int(void*, int, void*);
  CHECK(fmu.function<Ask>("fmi2GetRealStatus")(handle, 2, &value) == kOk);
  CHECK(value == doctest::Approx(0.02).epsilon(1e-12));
  int ends = 1;
  CHECK(fmu.function<Ask>("fmi2GetBooleanStatus")(handle, 3, &ends) == kOk);
  CHECK(ends == 0);
  for (const std::string type : {"", "Real", "Integer", "Boolean", "String"}) {
    const auto ask = fmu.function<Ask>(("fmi2Get" + type + "Status").c_str());
    CHECK(ask(handle, 0, &value) == kDiscard);
    CHECK(ask(nullptr, 0, &value) == kError);
  }
  CHECK(instance.outputs() == plain.outputs());
  CHECK(instance.call("fmi2Terminate") == kOk);
  refused(instance.step(0.02, 0.02), "terminated");
}
