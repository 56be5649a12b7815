// The functions of FMI 3.0 for co-simulation of which this FMU makes use.

#include <memory>
#include <optional>
#include <string>

#include "models/error.h"
#include "program/fmu/fmi3.h"
#include "program/fmu/library/answers.h"
#include "program/fmu/library/both_versions.h"
#include "program/fmu/library/instance.h"

namespace {

using namespace spoke;
using fmu::call;
using fmu::Instance;
using fmu::MessageSink;
using fmu::require_pointers;
using fmu::text_or_empty;

/// Returns where messages go by the callback of an importer.
MessageSink make_sink(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                      fmi3Boolean warns) {
  if (!log) return {{}, warns};
  return {[environment, log](fmu::Grade grade, const char* category, const char* text) {
            log(environment, static_cast<fmi3Status>(grade), category, text);
          },
          warns};
}

}  // namespace

SPOKE_FMI3 const char* fmi3GetVersion() { return "3.0"; }

SPOKE_FMI3 fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean loggingOn,
                                          std::size_t nCategories, const fmi3String categories[]) {
  return fmu::set_logging(instance, "fmi3SetDebugLogging", loggingOn, nCategories, categories);
}

SPOKE_FMI3 fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean,
    fmi3Boolean loggingOn, fmi3Boolean eventModeUsed, fmi3Boolean, const fmi3ValueReference[],
    std::size_t nRequiredIntermediateVariables, fmi3InstanceEnvironment instanceEnvironment,
    fmi3LogMessageCallback logMessage, fmi3IntermediateUpdateCallback) {
  const MessageSink messages = make_sink(instanceEnvironment, logMessage, loggingOn);
  fmi3Instance made = nullptr;
  fmu::guard(messages, "fmi3InstantiateCoSimulation", [&] {
    if (eventModeUsed) throw InputError("this FMU has no event mode");
    if (nRequiredIntermediateVariables > 0)
      throw InputError("this FMU has no intermediate variables");
    auto instance = std::make_unique<Instance>(
        fmu::InstanceRequest{text_or_empty(instanceName), text_or_empty(instantiationToken),
                             text_or_empty(resourcePath), messages});
    fmu::enlist(*instance);
    made = instance.release();
  });
  return made;
}

SPOKE_FMI3 void fmi3FreeInstance(fmi3Instance instance) { delete fmu::strike_off(instance); }

SPOKE_FMI3 fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64,
                                                  fmi3Float64 startTime,
                                                  fmi3Boolean stopTimeDefined,
                                                  fmi3Float64 stopTime) {
  return call(instance, "fmi3EnterInitializationMode", [&](Instance& own) {
    own.set_times(startTime, stopTimeDefined ? std::optional(stopTime) : std::nullopt);
    own.enter_initialization();
  });
}

SPOKE_FMI3 fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return call(instance, "fmi3ExitInitializationMode",
              [](Instance& own) { own.exit_initialization(); });
}

SPOKE_FMI3 fmi3Status fmi3Terminate(fmi3Instance instance) {
  return call(instance, "fmi3Terminate", [](Instance& own) { own.terminate(); });
}

SPOKE_FMI3 fmi3Status fmi3Reset(fmi3Instance instance) {
  return call(instance, "fmi3Reset", [](Instance& own) { own.reset(); });
}

SPOKE_FMI3 fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 currentCommunicationPoint,
                                 fmi3Float64 communicationStepSize, fmi3Boolean,
                                 fmi3Boolean* eventHandlingNeeded, fmi3Boolean* terminateSimulation,
                                 fmi3Boolean* earlyReturn, fmi3Float64* lastSuccessfulTime) {
  return call(instance, "fmi3DoStep", [&](Instance& own) {
    require_pointers(
        eventHandlingNeeded && terminateSimulation && earlyReturn && lastSuccessfulTime,
        "one of the places for results");
    *eventHandlingNeeded = *terminateSimulation = *earlyReturn = false;
    *lastSuccessfulTime = own.time();
    own.do_step(currentCommunicationPoint, communicationStepSize);
    *lastSuccessfulTime = currentCommunicationPoint + communicationStepSize;
  });
}

SPOKE_FMI3 fmi3Status fmi3GetFloat64(fmi3Instance instance,
                                     const fmi3ValueReference valueReferences[],
                                     std::size_t nValueReferences, fmi3Float64 values[],
                                     std::size_t nValues) {
  return fmu::get_values(instance, "fmi3GetFloat64", valueReferences, nValueReferences, values,
                         nValues);
}

SPOKE_FMI3 fmi3Status fmi3SetFloat64(fmi3Instance instance,
                                     const fmi3ValueReference valueReferences[],
                                     std::size_t nValueReferences, const fmi3Float64 values[],
                                     std::size_t nValues) {
  return fmu::set_values(instance, "fmi3SetFloat64", valueReferences, nValueReferences, values,
                         nValues);
}

// States.

SPOKE_FMI3 fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* FMUState) {
  return fmu::save_state(instance, "fmi3GetFMUState", FMUState);
}

SPOKE_FMI3 fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState FMUState) {
  return fmu::go_back(instance, "fmi3SetFMUState", FMUState);
}

SPOKE_FMI3 fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* FMUState) {
  return fmu::free_state(instance, "fmi3FreeFMUState", FMUState);
}

SPOKE_FMI3 fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState FMUState,
                                                 std::size_t* size) {
  return fmu::size_state(instance, "fmi3SerializedFMUStateSize", FMUState, size);
}

SPOKE_FMI3 fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState FMUState,
                                            fmi3Byte serializedState[], std::size_t size) {
  return fmu::serialize_state(instance, "fmi3SerializeFMUState", FMUState, serializedState, size);
}

SPOKE_FMI3 fmi3Status fmi3DeserializeFMUState(fmi3Instance instance,
                                              const fmi3Byte serializedState[], std::size_t size,
                                              fmi3FMUState* FMUState) {
  return fmu::deserialize_state(instance, "fmi3DeserializeFMUState", serializedState, size,
                                FMUState);
}
