#pragma once

// The types of FMI 3.0 (Functional Mock-up Interface, fmi-standard.org) that functions of an FMU
// take and return, and the marks of these functions. Written for Spoke from the text of the
// standard: names and meanings are its own.

#include <cstddef>
#include <cstdint>

/// Marks a function that importers find by its name.
#define SPOKE_FMI3 extern "C" __attribute__((visibility("default")))

// Handles, which mean something to the side only that has made them.
using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;

// Values of variables, by the names of their types.
using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Int8 = std::int8_t;
using fmi3UInt8 = std::uint8_t;
using fmi3Int16 = std::int16_t;
using fmi3UInt16 = std::uint16_t;
using fmi3Int32 = std::int32_t;
using fmi3UInt32 = std::uint32_t;
using fmi3Int64 = std::int64_t;
using fmi3UInt64 = std::uint64_t;
using fmi3Boolean = bool;
using fmi3Clock = bool;
using fmi3Byte = std::uint8_t;
using fmi3String = const char*;
using fmi3Binary = const fmi3Byte*;
using fmi3ValueReference = std::uint32_t;

/// The outcome of a call, from good to bad.
enum fmi3Status {
  fmi3OK,
  fmi3Warning,  ///< done, but something is doubtful
  fmi3Discard,  ///< not done; the instance is as before
  fmi3Error,    ///< not done; the instance may only be reset, freed or set to another state
  fmi3Fatal,    ///< not done; no instance can be used any more
};

/// How a variable depends on another one.
enum fmi3DependencyKind {
  fmi3Independent,
  fmi3Constant,
  fmi3Fixed,
  fmi3Tunable,
  fmi3Discrete,
  fmi3Dependent,
};

/// Whether the interval of a clock is known, or has changed.
enum fmi3IntervalQualifier {
  fmi3IntervalNotYetKnown,
  fmi3IntervalUnchanged,
  fmi3IntervalChanged,
};

// Functions of the importer.
using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment environment, fmi3Status status,
                                        fmi3String category, fmi3String message);
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment environment,
                                                fmi3Float64 time, fmi3Boolean set_requested,
                                                fmi3Boolean get_allowed, fmi3Boolean step_finished,
                                                fmi3Boolean can_return_early,
                                                fmi3Boolean* early_return_requested,
                                                fmi3Float64* early_return_time);
using fmi3ClockUpdateCallback = void (*)(fmi3InstanceEnvironment environment);
using fmi3LockPreemptionCallback = void (*)();
using fmi3UnlockPreemptionCallback = void (*)();
