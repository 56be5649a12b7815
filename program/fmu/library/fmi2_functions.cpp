// The functions of FMI 2.0 for co-simulation of which this FMU makes use: another face of the same
// instances.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "program/fmu/fmi2.h"
#include "program/fmu/library/answers.h"
#include "program/fmu/library/instance.h"
#include "program/fmu/library/resource_location.h"

namespace {

using namespace spoke;
using fmu::call;
using fmu::Instance;
using fmu::MessageSink;
using fmu::require_pointers;
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
  return call(instance, "fmi2SetDebugLogging", [&](Instance& own) {
    require_pointers(nCategories == 0 || categories, "categories");
    std::vector<std::string> names;
    for (std::size_t k = 0; k < nCategories; ++k) names.push_back(text_or_empty(categories[k]));
    own.set_logging(loggingOn != 0, names);
  });
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
  return call(instance, "fmi2GetReal", [&](Instance& own) {
    require_pointers(count == 0 || (references && values), "references or values");
    own.get({references, count}, {values, count});
  });
}

SPOKE_FMI2 fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference references[],
                                  std::size_t count, const fmi2Real values[]) {
  return call(instance, "fmi2SetReal", [&](Instance& own) {
    require_pointers(count == 0 || (references && values), "references or values");
    own.set({references, count}, {values, count});
  });
}

// States.

SPOKE_FMI2 fmi2Status fmi2GetFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return call(instance, "fmi2GetFMUstate", [&](Instance& own) {
    require_pointers(state, "the place of the state");
    *state = own.save(*state);
  });
}

SPOKE_FMI2 fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate state) {
  return call(instance, "fmi2SetFMUstate", [&](Instance& own) { own.go_back(state); });
}

SPOKE_FMI2 fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return call(instance, "fmi2FreeFMUstate", [&](Instance& own) {
    if (!state || !*state) return;
    own.forget(*state);
    *state = nullptr;
  });
}

SPOKE_FMI2 fmi2Status fmi2SerializedFMUstateSize(fmi2Component instance, fmi2FMUstate state,
                                                 std::size_t* size) {
  return call(instance, "fmi2SerializedFMUstateSize", [&](Instance& own) {
    require_pointers(size, "the place of the size");
    *size = own.serialize(state).size();
  });
}

SPOKE_FMI2 fmi2Status fmi2SerializeFMUstate(fmi2Component instance, fmi2FMUstate state,
                                            fmi2Byte serializedState[], std::size_t size) {
  return call(instance, "fmi2SerializeFMUstate", [&](Instance& own) {
    require_pointers(serializedState, "the place of the bytes");
    const std::string bytes = own.serialize(state, size);
    std::copy(bytes.begin(), bytes.end(), serializedState);
  });
}

SPOKE_FMI2 fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance,
                                              const fmi2Byte serializedState[], std::size_t size,
                                              fmi2FMUstate* state) {
  return call(instance, "fmi2DeSerializeFMUstate", [&](Instance& own) {
    require_pointers(serializedState && state, "the bytes or the place of the state");
    *state = own.deserialize({serializedState, size});
  });
}
