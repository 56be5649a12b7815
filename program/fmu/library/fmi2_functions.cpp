// The functions of FMI 2.0 for co-simulation of which this FMU makes use: another face of the same
// instances.

#include <memory>
#include <optional>
#include <string>

#include "models/error.h"
#include "program/fmu/fmi2.h"
#include "program/fmu/library/answers.h"
#include "program/fmu/library/both_versions.h"
#include "program/fmu/library/instance.h"
#include "program/fmu/library/resource_location.h"

namespace {

using namespace spoke;
using fmu::call;
using fmu::Instance;
using fmu::MessageSink;
using fmu::text_or_empty;

/// Returns where messages go by the callbacks of an importer, which may forget them.
MessageSink make_sink(const fmi2CallbackFunctions* functions, const std::string& name,
                      fmi2Boolean warns) {
  if (!functions || !functions->logger) return {{}, warns != 0};
  return {[log = functions->logger, environment = functions->componentEnvironment, name](
              fmu::Grade grade, const char* category, const char* text) {
            log(environment, name.c_str(), static_cast<fmi2Status>(grade), category, "%s", text);
          },
          warns != 0};
}

}  // namespace

SPOKE_FMI2 const char* fmi2GetTypesPlatform() { return "default"; }
SPOKE_FMI2 const char* fmi2GetVersion() { return "2.0"; }

SPOKE_FMI2 fmi2Status fmi2SetDebugLogging(fmi2Component instance, fmi2Boolean loggingOn,
                                          std::size_t nCategories, const fmi2String categories[]) {
  return fmu::set_logging(instance, "fmi2SetDebugLogging", loggingOn != 0, nCategories, categories);
}

SPOKE_FMI2 fmi2Component fmi2Instantiate(fmi2String instanceName, fmi2Type fmuType,
                                         fmi2String fmuGUID, fmi2String fmuResourceLocation,
                                         const fmi2CallbackFunctions* functions, fmi2Boolean,
                                         fmi2Boolean loggingOn) {
  const std::string name = text_or_empty(instanceName);
  const MessageSink messages = make_sink(functions, name, loggingOn);
  fmi2Component made = nullptr;
  fmu::guard(messages, "fmi2Instantiate", [&] {
    if (fmuType != fmi2CoSimulation)
      throw InputError("this FMU is for co-simulation, not for model exchange");
    auto instance = std::make_unique<Instance>(
        fmu::InstanceRequest{name, text_or_empty(fmuGUID),
                             fmu::path_of_location(text_or_empty(fmuResourceLocation)), messages});
    fmu::enlist(*instance);
    made = instance.release();
  });
  return made;
}

SPOKE_FMI2 void fmi2FreeInstance(fmi2Component instance) { delete fmu::strike_off(instance); }

SPOKE_FMI2 fmi2Status fmi2SetupExperiment(fmi2Component instance, fmi2Boolean, fmi2Real,
                                          fmi2Real startTime, fmi2Boolean stopTimeDefined,
                                          fmi2Real stopTime) {
  return call(instance, "fmi2SetupExperiment", [&](Instance& own) {
    own.set_times(startTime, stopTimeDefined != 0 ? std::optional(stopTime) : std::nullopt);
  });
}

SPOKE_FMI2 fmi2Status fmi2EnterInitializationMode(fmi2Component instance) {
  return call(instance, "fmi2EnterInitializationMode",
              [](Instance& own) { own.enter_initialization(); });
}

SPOKE_FMI2 fmi2Status fmi2ExitInitializationMode(fmi2Component instance) {
  return call(instance, "fmi2ExitInitializationMode",
              [](Instance& own) { own.exit_initialization(); });
}

SPOKE_FMI2 fmi2Status fmi2Terminate(fmi2Component instance) {
  return call(instance, "fmi2Terminate", [](Instance& own) { own.terminate(); });
}

SPOKE_FMI2 fmi2Status fmi2Reset(fmi2Component instance) {
  return call(instance, "fmi2Reset", [](Instance& own) { own.reset(); });
}

SPOKE_FMI2 fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real currentCommunicationPoint,
                                 fmi2Real communicationStepSize, fmi2Boolean) {
  return call(instance, "fmi2DoStep", [&](Instance& own) {
    own.do_step(currentCommunicationPoint, communicationStepSize);
  });
}

SPOKE_FMI2 fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference references[],
                                  std::size_t count, fmi2Real values[]) {
  return fmu::get_values(instance, "fmi2GetReal", references, count, values, count);
}

SPOKE_FMI2 fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference references[],
                                  std::size_t count, const fmi2Real values[]) {
  return fmu::set_values(instance, "fmi2SetReal", references, count, values, count);
}

// States.

SPOKE_FMI2 fmi2Status fmi2GetFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return fmu::save_state(instance, "fmi2GetFMUstate", state);
}

SPOKE_FMI2 fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate state) {
  return fmu::go_back(instance, "fmi2SetFMUstate", state);
}

SPOKE_FMI2 fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return fmu::free_state(instance, "fmi2FreeFMUstate", state);
}

SPOKE_FMI2 fmi2Status fmi2SerializedFMUstateSize(fmi2Component instance, fmi2FMUstate state,
                                                 std::size_t* size) {
  return fmu::size_state(instance, "fmi2SerializedFMUstateSize", state, size);
}

SPOKE_FMI2 fmi2Status fmi2SerializeFMUstate(fmi2Component instance, fmi2FMUstate state,
                                            fmi2Byte serializedState[], std::size_t size) {
  return fmu::serialize_state(instance, "fmi2SerializeFMUstate", state, serializedState, size);
}

SPOKE_FMI2 fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance,
                                              const fmi2Byte serializedState[], std::size_t size,
                                              fmi2FMUstate* state) {
  return fmu::deserialize_state(instance, "fmi2DeSerializeFMUstate", serializedState, size, state);
}
