// Functions of FMI 3.0 for what this FMU does not have, as its modelDescription.xml says.

#include <cstddef>

#include "program/fmu/fmi3.h"
#include "program/fmu/library/answers.h"

using spoke::fmu::not_there;

namespace {

/// Answers an importer that wants an instance of another kind.
fmi3Instance refuse_kind(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                         const char* text) {
  if (log) log(environment, fmi3Error, "logStatusError", text);
  return nullptr;
}

}  // namespace

SPOKE_FMI3 fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String,
                                                     fmi3Boolean, fmi3Boolean,
                                                     fmi3InstanceEnvironment instanceEnvironment,
                                                     fmi3LogMessageCallback logMessage) {
  return refuse_kind(instanceEnvironment, logMessage,
                     "this FMU is for co-simulation, not for model exchange");
}

SPOKE_FMI3 fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
    fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3ClockUpdateCallback, fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback) {
  return refuse_kind(instanceEnvironment, logMessage,
                     "this FMU is for co-simulation, not for scheduled execution");
}

SPOKE_FMI3 fmi3Status fmi3EnterEventMode(fmi3Instance instance) {
  return not_there(instance, "fmi3EnterEventMode", "event mode");
}
SPOKE_FMI3 fmi3Status fmi3EnterStepMode(fmi3Instance instance) {
  return not_there(instance, "fmi3EnterStepMode", "event mode to leave");
}
SPOKE_FMI3 fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) {
  return not_there(instance, "fmi3EnterConfigurationMode", "structural parameters");
}
SPOKE_FMI3 fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) {
  return not_there(instance, "fmi3ExitConfigurationMode", "structural parameters");
}
SPOKE_FMI3 fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) {
  return not_there(instance, "fmi3EvaluateDiscreteStates", "discrete states");
}
SPOKE_FMI3 fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean*, fmi3Boolean*,
                                               fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                               fmi3Float64*) {
  return not_there(instance, "fmi3UpdateDiscreteStates", "discrete states");
}
SPOKE_FMI3 fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference,
                                                          std::size_t*) {
  return not_there(instance, "fmi3GetNumberOfVariableDependencies", "dependencies of elements");
}
SPOKE_FMI3 fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference,
                                                  std::size_t[], fmi3ValueReference[],
                                                  std::size_t[], fmi3DependencyKind[],
                                                  std::size_t) {
  return not_there(instance, "fmi3GetVariableDependencies", "dependencies of elements");
}
SPOKE_FMI3 fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance,
                                                   const fmi3ValueReference[], std::size_t,
                                                   const fmi3ValueReference[], std::size_t,
                                                   const fmi3Float64[], std::size_t, fmi3Float64[],
                                                   std::size_t) {
  return not_there(instance, "fmi3GetDirectionalDerivative", "directional derivatives");
}
SPOKE_FMI3 fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference[],
                                               std::size_t, const fmi3ValueReference[], std::size_t,
                                               const fmi3Float64[], std::size_t, fmi3Float64[],
                                               std::size_t) {
  return not_there(instance, "fmi3GetAdjointDerivative", "adjoint derivatives");
}
SPOKE_FMI3 fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference[],
                                               std::size_t, const fmi3Int32[], fmi3Float64[],
                                               std::size_t) {
  return not_there(instance, "fmi3GetOutputDerivatives", "derivatives of outputs");
}

// Of model exchange and of scheduled execution, which importers look for in every FMU.

namespace {

constexpr const char* kExchange = "model exchange, it is for co-simulation";

}  // namespace

SPOKE_FMI3 fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance) {
  return not_there(instance, "fmi3EnterContinuousTimeMode", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean, fmi3Boolean*,
                                                  fmi3Boolean*) {
  return not_there(instance, "fmi3CompletedIntegratorStep", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64) {
  return not_there(instance, "fmi3SetTime", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64[],
                                              std::size_t) {
  return not_there(instance, "fmi3SetContinuousStates", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64[],
                                                        std::size_t) {
  return not_there(instance, "fmi3GetContinuousStateDerivatives", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64[], std::size_t) {
  return not_there(instance, "fmi3GetEventIndicators", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64[], std::size_t) {
  return not_there(instance, "fmi3GetContinuousStates", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64[],
                                                        std::size_t) {
  return not_there(instance, "fmi3GetNominalsOfContinuousStates", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, std::size_t*) {
  return not_there(instance, "fmi3GetNumberOfEventIndicators", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, std::size_t*) {
  return not_there(instance, "fmi3GetNumberOfContinuousStates", kExchange);
}
SPOKE_FMI3 fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference,
                                                 fmi3Float64) {
  return not_there(instance, "fmi3ActivateModelPartition", "clocks");
}
