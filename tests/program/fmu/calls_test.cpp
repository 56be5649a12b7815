// Calls that the standard does not allow, and values that are none: each is answered by an error
// and a sentence, and the instance goes on as if they had not been.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/file_text.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/unpacked_fmu.h"

using namespace spoke::test;

namespace {

/// What the standard's functions are called behind "fmi3".
const char* const kFunctions = R"(
ActivateModelPartition CompletedIntegratorStep DeserializeFMUState DoStep EnterConfigurationMode
EnterContinuousTimeMode EnterEventMode EnterInitializationMode EnterStepMode
EvaluateDiscreteStates ExitConfigurationMode ExitInitializationMode FreeFMUState FreeInstance
GetAdjointDerivative GetBinary GetBoolean GetClock GetContinuousStateDerivatives
GetContinuousStates GetDirectionalDerivative GetEventIndicators GetFMUState GetFloat32
GetFloat64 GetInt16 GetInt32 GetInt64 GetInt8 GetIntervalDecimal GetIntervalFraction
GetNominalsOfContinuousStates GetNumberOfContinuousStates GetNumberOfEventIndicators
GetNumberOfVariableDependencies GetOutputDerivatives GetShiftDecimal GetShiftFraction GetString
GetUInt16 GetUInt32 GetUInt64 GetUInt8 GetVariableDependencies GetVersion
InstantiateCoSimulation InstantiateModelExchange InstantiateScheduledExecution Reset
SerializeFMUState SerializedFMUStateSize SetBinary SetBoolean SetClock SetContinuousStates
SetDebugLogging SetFMUState SetFloat32 SetFloat64 SetInt16 SetInt32 SetInt64 SetInt8
SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction SetString SetTime
SetUInt16 SetUInt32 SetUInt64 SetUInt8 Terminate UpdateDiscreteStates
)";

const UnpackedFmu& unpacked() {
  static const UnpackedFmu fmu(kPitchedRotor);
  return fmu;
}

}  // namespace

TEST_CASE("instances are made of this FMU's token and resources only") {
  const LoadedFmu fmu(unpacked().folder());
  const FmuInstance wrong(fmu, "another token");
  CHECK(!wrong.handle());
  CHECK(contains(wrong.last(), "another token"));
  CHECK(contains(wrong.last(), fmu.token()));
  const FmuInstance lost(fmu, "", "/nowhere/resources/");
  CHECK(!lost.handle());
  CHECK(contains(lost.last(), "/nowhere/resources/spoke.toml"));
  using Make = void*(const char*, const char*, const char*, bool, bool, bool, bool,
                     const std::uint32_t*, std::size_t, void*, void*, void*);
  const auto make = fmu.function<Make>("fmi3InstantiateCoSimulation");
  CHECK(!make(nullptr, nullptr, nullptr, false, false, false, false, nullptr, 0, nullptr, nullptr,
              nullptr));
  CHECK(!make("x", fmu.token().c_str(), fmu.resources().c_str(), false, false, true, false, nullptr,
              0, nullptr, nullptr, nullptr));  // there is no event mode
  const std::uint32_t reference = 1;
  CHECK(!make("x", fmu.token().c_str(), fmu.resources().c_str(), false, false, false, false,
              &reference, 1, nullptr, nullptr, nullptr));
  using Other = void*(const char*, const char*, const char*, bool, bool, void*, void*);
  CHECK(!fmu.function<Other>("fmi3InstantiateModelExchange")(
      "x", fmu.token().c_str(), fmu.resources().c_str(), false, false, nullptr, nullptr));
  CHECK(std::string(fmu.function<const char*()>("fmi3GetVersion")()) == "3.0");
}

TEST_CASE("all functions of the standard are there, since importers look for them") {
  const LoadedFmu fmu(unpacked().folder());
  std::istringstream names(kFunctions);
  for (std::string name; names >> name;)
    CHECK_NOTHROW(fmu.function<void()>(("fmi3" + name).c_str()));
  // What is not part of co-simulation only answers.
  FmuInstance instance(fmu);
  CHECK(instance.call("fmi3EnterContinuousTimeMode") == kError);
  CHECK(contains(instance.last(), "co-simulation"));
}

TEST_CASE("calls out of order are errors, and change nothing") {
  const LoadedFmu fmu(unpacked().folder());
  FmuInstance instance(fmu);
  REQUIRE(instance.handle());
  std::vector<double> values(1);
  const auto refused = [&](int status, const char* part) {
    CAPTURE(part);
    CAPTURE(instance.last());
    CHECK(status == kError);
    CHECK(contains(instance.last(), part));
  };
  // Before initialization.
  refused(instance.step(0.0, 0.02), "instantiated");
  refused(instance.call("fmi3ExitInitializationMode"), "instantiated");
  refused(instance.call("fmi3Terminate"), "instantiated");
  refused(instance.get({fmu.reference("hub.speed")}, values), "instantiated");
  CHECK(instance.get({fmu.reference("drive.torque")}, values) == kOk);
  CHECK(instance.set({"load.gust"}, {1.0}) == kOk);
  refused(instance.enter_initialization(std::nan("")), "finite");
  // In it.
  CHECK(instance.enter_initialization() == kOk);
  refused(instance.enter_initialization(), "in initialization mode");
  refused(instance.step(0.0, 0.02), "in initialization mode");
  CHECK(instance.get({fmu.reference("hub.speed")}, values) == kOk);
  CHECK(values[0] == 4.0);
  CHECK(instance.call("fmi3ExitInitializationMode") == kOk);
  // Behind it.
  refused(instance.call("fmi3ExitInitializationMode"), "in step mode");
  refused(instance.enter_initialization(), "in step mode");
  for (const char* name : {"fmi3EnterEventMode", "fmi3EnterStepMode", "fmi3EnterConfigurationMode",
                           "fmi3ExitConfigurationMode", "fmi3EvaluateDiscreteStates"})
    refused(instance.call(name), "this FMU has no ");
  CHECK(instance.step(0.0, 0.02) == kOk);
  CHECK(instance.call("fmi3Terminate") == kOk);
  refused(instance.step(0.02, 0.02), "terminated");
  refused(instance.set({"load.gust"}, {1.0}), "terminated");
  CHECK(instance.get({fmu.reference("hub.speed")}, values) == kOk);
  CHECK(instance.call("fmi3Reset") == kOk);
  CHECK(instance.initialize() == kOk);
  CHECK(instance.step(0.0, 0.02) == kOk);
}

TEST_CASE("values, references and times that are none are errors, and change nothing") {
  const LoadedFmu fmu(unpacked().folder());
  FmuInstance instance(fmu), plain(fmu);
  CHECK(instance.initialize() == kOk);
  CHECK(plain.initialize() == kOk);
  std::vector<double> values(1);
  const auto refused = [&](int status, const char* part) {
    CAPTURE(part);
    CAPTURE(instance.last());
    CHECK(status == kError);
    CHECK(contains(instance.last(), part));
  };
  const double infinity = std::numeric_limits<double>::infinity();
  refused(instance.set({"load.gust"}, {std::nan("")}), "load.gust");
  refused(instance.set({"drive.torque", "load.gust"}, {7.0, infinity}), "not finite");
  refused(instance.set({"time"}, {1.0}), "no input");
  refused(instance.set({"hub.speed"}, {1.0}), "no input");
  refused(instance.get({12345}, values), "12345");
  refused(instance.set({"load.gust"}, {1.0, 2.0}), "a value for each");
  refused(instance.step(0.02, 0.02), "communication point");
  refused(instance.step(0.0, 0.003), "multiple of the model's step, 0.004 s");
  refused(instance.step(0.0, 0.0), "multiple");
  refused(instance.step(0.0, -0.004), "multiple");
  refused(instance.step(0.0, infinity), "multiple");
  refused(instance.step(std::nan(""), 0.004), "communication point");
  refused(instance.step(0.0, 1e12), "as many steps as it can");
  for (int k = 0; k < 5; ++k) {
    CHECK(instance.step(0.004 * k, 0.004) == kOk);
    CHECK(plain.step(0.004 * k, 0.004) == kOk);
  }
  CHECK(instance.outputs() == plain.outputs());
}

TEST_CASE("null pointers and handles of nothing are errors") {
  const LoadedFmu fmu(unpacked().folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  void* const handle = instance.handle();
  const auto one = [&](const char* name) { return fmu.function<int(void*)>(name); };
  int number = 0;
  void* const no_instance = &number;
  for (const char* name : {"fmi3ExitInitializationMode", "fmi3Terminate", "fmi3Reset"})
    for (void* const none : {static_cast<void*>(nullptr), no_instance})
      CHECK(one(name)(none) == kError);
  fmu.function<void(void*)>("fmi3FreeInstance")(nullptr);
  fmu.function<void(void*)>("fmi3FreeInstance")(no_instance);
  using Get = int(void*, const std::uint32_t*, std::size_t, double*, std::size_t);
  const std::uint32_t reference = 1;
  double value = 0.0;
  for (const char* name : {"fmi3GetFloat64", "fmi3SetFloat64"}) {
    const auto get = fmu.function<Get>(name);
    CHECK(get(nullptr, &reference, 1, &value, 1) == kError);
    CHECK(get(handle, nullptr, 1, &value, 1) == kError);
    CHECK(get(handle, &reference, 1, nullptr, 1) == kError);
    CHECK(get(handle, nullptr, 0, nullptr, 0) == kOk);
  }
  using Step = int(void*, double, double, bool, bool*, bool*, bool*, double*);
  CHECK(fmu.function<Step>("fmi3DoStep")(handle, 0.0, 0.02, true, nullptr, nullptr, nullptr,
                                         nullptr) == kError);
  // States.
  const auto get_state = fmu.function<int(void*, void**)>("fmi3GetFMUState");
  const auto set_state = fmu.function<int(void*, void*)>("fmi3SetFMUState");
  const auto free_state = fmu.function<int(void*, void**)>("fmi3FreeFMUState");
  CHECK(get_state(handle, nullptr) == kError);
  CHECK(set_state(handle, nullptr) == kError);
  CHECK(set_state(handle, &number) == kError);
  void* other = &number;
  CHECK(get_state(handle, &other) == kError);
  CHECK(free_state(handle, &other) == kError);
  CHECK(free_state(handle, nullptr) == kOk);
  void* nothing = nullptr;
  CHECK(free_state(handle, &nothing) == kOk);
  using Size = int(void*, void*, std::size_t*);
  CHECK(fmu.function<Size>("fmi3SerializedFMUStateSize")(handle, nullptr, nullptr) == kError);
  using Read = int(void*, const std::uint8_t*, std::size_t, void**);
  CHECK(fmu.function<Read>("fmi3DeserializeFMUState")(handle, nullptr, 3, &nothing) == kError);
  // Variables of other types.
  using Any = int(void*, const std::uint32_t*, std::size_t, void*, std::size_t);
  for (const std::string type : {"Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32",
                                 "Int64", "UInt64", "Boolean", "String"})
    for (const std::string verb : {"fmi3Get", "fmi3Set"}) {
      const auto get = fmu.function<Any>((verb + type).c_str());
      CHECK(get(handle, nullptr, 0, nullptr, 0) == kOk);
      CHECK(get(handle, &reference, 1, &value, 1) == kError);
    }
  CHECK(instance.step(0.0, 0.02) == kOk);
}

TEST_CASE("bytes that are no state of this FMU are errors") {
  const LoadedFmu fmu(unpacked().folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  CHECK(instance.step(0.0, 0.02) == kOk);
  void* state = nullptr;
  CHECK(instance.get_state(&state) == kOk);
  const std::vector<std::uint8_t> bytes = instance.serialize(state);
  const std::vector<double> expected = instance.outputs();
  void* read = nullptr;
  for (std::size_t k = 0; k < bytes.size(); k += 1 + bytes.size() / 60) {
    std::vector<std::uint8_t> damaged = bytes;
    damaged[k] ^= 0x21;
    CHECK(instance.deserialize(damaged, &read) == kError);
    damaged = bytes;
    damaged.resize(k);
    CHECK(instance.deserialize(damaged, &read) == kError);
  }
  CHECK(!read);
  const UnpackedFmu unlike(kDrivenRotor);
  const LoadedFmu other_fmu(unlike.folder());
  FmuInstance other(other_fmu);
  CHECK(other.deserialize(bytes, &read) == kError);
  CHECK(contains(other.last(), "another FMU"));
  CHECK(instance.outputs() == expected);
  CHECK(instance.deserialize(bytes, &read) == kOk);
  CHECK(instance.set_state(read) == kOk);
  CHECK(instance.outputs() == expected);
}

TEST_CASE("warnings of the engine are messages where they are asked for") {
  const UnpackedFmu doubtful(kPitchedRotor, {"load.gust"}, {}, {"limits.deflection=0.001"});
  const LoadedFmu fmu(doubtful.folder());
  FmuInstance instance(fmu), silent(fmu);
  using Logging = int(void*, bool, std::size_t, const char* const*);
  const auto logging = fmu.function<Logging>("fmi3SetDebugLogging");
  const char* const category = "logStatusWarning";
  const char* const unknown = "logEvents";
  CHECK(logging(silent.handle(), false, 1, &category) == kOk);
  CHECK(logging(silent.handle(), true, 1, &unknown) == kError);
  CHECK(logging(silent.handle(), true, 1, nullptr) == kError);
  silent.messages.clear();
  for (FmuInstance* each : {&instance, &silent}) {
    CHECK(each->initialize() == kOk);
    CHECK(each->step(0.0, 0.4) == kOk);
  }
  REQUIRE(!instance.messages.empty());
  CHECK(instance.messages[0].status == kWarning);
  CHECK(instance.messages[0].category == "logStatusWarning");
  CHECK(silent.messages.empty());
}
