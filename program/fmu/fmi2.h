#pragma once

// The types of FMI 2.0 (Functional Mock-up Interface, fmi-standard.org) that functions of an FMU
// take and return, and the mark of these functions. Written for Spoke from the text of the
// standard: names and meanings are its own.

#include <cstddef>

/// Marks a function that importers find by its name.
#define SPOKE_FMI2 extern "C" __attribute__((visibility("default")))

// Handles, which mean something to the side only that has made them.
using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;

// Values of variables, by the names of their types.
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

/// The outcome of a call, from good to bad.
enum fmi2Status {
  fmi2OK,
  fmi2Warning,  ///< done, but something is doubtful
  fmi2Discard,  ///< not done, or not known; the instance is as before
  fmi2Error,    ///< not done; the instance may only be reset, freed or set to another state
  fmi2Fatal,    ///< not done; no instance can be used any more
  fmi2Pending,  ///< going on
};

/// What an instance is made for.
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };

/// What importers ask about a step.
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

// Functions of the importer. A message is a format of printf.
using fmi2CallbackLogger = void (*)(fmi2ComponentEnvironment environment, fmi2String instance_name,
                                    fmi2Status status, fmi2String category, fmi2String message,
                                    ...);
using fmi2CallbackAllocateMemory = void* (*)(std::size_t count, std::size_t size);
using fmi2CallbackFreeMemory = void (*)(void* memory);
using fmi2StepFinished = void (*)(fmi2ComponentEnvironment environment, fmi2Status status);

struct fmi2CallbackFunctions {
  fmi2CallbackLogger logger;
  fmi2CallbackAllocateMemory allocateMemory;
  fmi2CallbackFreeMemory freeMemory;
  fmi2StepFinished stepFinished;
  fmi2ComponentEnvironment componentEnvironment;
};
