// Functions of FMI 2.0 for types of which this FMU has no variables, for what it does not have, as
// its modelDescription.xml says, and for steps that end later, which its steps do not.

#include <cstddef>

#include "program/fmu/fmi2.h"
#include "program/fmu/library/answers.h"
#include "program/fmu/library/instance.h"

using Fmi2References = const fmi2ValueReference[];
using spoke::fmu::call;
using spoke::fmu::Instance;
using spoke::fmu::no_variables;
using spoke::fmu::not_there;
using spoke::fmu::require_pointers;

SPOKE_FMI2 fmi2Status fmi2GetInteger(fmi2Component instance, Fmi2References, std::size_t count,
                                     fmi2Integer[]) {
  return no_variables(instance, "fmi2GetInteger", count);
}
SPOKE_FMI2 fmi2Status fmi2SetInteger(fmi2Component instance, Fmi2References, std::size_t count,
                                     const fmi2Integer[]) {
  return no_variables(instance, "fmi2SetInteger", count);
}
SPOKE_FMI2 fmi2Status fmi2GetBoolean(fmi2Component instance, Fmi2References, std::size_t count,
                                     fmi2Boolean[]) {
  return no_variables(instance, "fmi2GetBoolean", count);
}
SPOKE_FMI2 fmi2Status fmi2SetBoolean(fmi2Component instance, Fmi2References, std::size_t count,
                                     const fmi2Boolean[]) {
  return no_variables(instance, "fmi2SetBoolean", count);
}
SPOKE_FMI2 fmi2Status fmi2GetString(fmi2Component instance, Fmi2References, std::size_t count,
                                    fmi2String[]) {
  return no_variables(instance, "fmi2GetString", count);
}
SPOKE_FMI2 fmi2Status fmi2SetString(fmi2Component instance, Fmi2References, std::size_t count,
                                    const fmi2String[]) {
  return no_variables(instance, "fmi2SetString", count);
}

SPOKE_FMI2 fmi2Status fmi2GetDirectionalDerivative(fmi2Component instance, Fmi2References,
                                                   std::size_t, Fmi2References, std::size_t,
                                                   const fmi2Real[], fmi2Real[]) {
  return not_there(instance, "fmi2GetDirectionalDerivative", "directional derivatives");
}
SPOKE_FMI2 fmi2Status fmi2SetRealInputDerivatives(fmi2Component instance, Fmi2References,
                                                  std::size_t, const fmi2Integer[],
                                                  const fmi2Real[]) {
  return not_there(instance, "fmi2SetRealInputDerivatives", "derivatives of inputs");
}
SPOKE_FMI2 fmi2Status fmi2GetRealOutputDerivatives(fmi2Component instance, Fmi2References,
                                                   std::size_t, const fmi2Integer[], fmi2Real[]) {
  return not_there(instance, "fmi2GetRealOutputDerivatives", "derivatives of outputs");
}
SPOKE_FMI2 fmi2Status fmi2CancelStep(fmi2Component instance) {
  return not_there(instance, "fmi2CancelStep", "steps that end later");
}

namespace {

/// Answers what is not known of a step.
fmi2Status is_not_known(fmi2Component instance) {
  return spoke::fmu::find(instance) ? fmi2Discard : fmi2Error;
}

}  // namespace

SPOKE_FMI2 fmi2Status fmi2GetStatus(fmi2Component instance, fmi2StatusKind, fmi2Status*) {
  return is_not_known(instance);
}
SPOKE_FMI2 fmi2Status fmi2GetRealStatus(fmi2Component instance, fmi2StatusKind kind,
                                        fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return is_not_known(instance);
  return call(instance, "fmi2GetRealStatus", [&](Instance& own) {
    require_pointers(value, "the place of the value");
    *value = own.time();
  });
}
SPOKE_FMI2 fmi2Status fmi2GetIntegerStatus(fmi2Component instance, fmi2StatusKind, fmi2Integer*) {
  return is_not_known(instance);
}
SPOKE_FMI2 fmi2Status fmi2GetBooleanStatus(fmi2Component instance, fmi2StatusKind kind,
                                           fmi2Boolean* value) {
  if (kind != fmi2Terminated) return is_not_known(instance);
  return call(instance, "fmi2GetBooleanStatus", [&](Instance&) {
    require_pointers(value, "the place of the value");
    *value = 0;  // no simulation ends by itself
  });
}
SPOKE_FMI2 fmi2Status fmi2GetStringStatus(fmi2Component instance, fmi2StatusKind, fmi2String*) {
  return is_not_known(instance);
}
