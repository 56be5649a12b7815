#pragma once

// How a simulation ends that does not come to its end.

#include <string>

#include "spoke/error.h"
#include "spoke/export.h"

namespace spoke {

/// A simulation that left the range of its model: one sentence naming time, step, subsystem, body,
/// node of the graph and quantity, and what to try. The program ends with status 3.
class SPOKE_EXPORT DivergenceError : public Error {
 public:
  /// ErrorCode::diverged.
  explicit DivergenceError(const std::string& sentence) : Error(ErrorCode::diverged, sentence) {}
};

/// A load of the user's that failed: one sentence naming load, blade, time, step, and what it said.
/// The simulation stands at the end of the step before, and can be stepped again.
class SPOKE_EXPORT LoadError : public Error {
 public:
  /// ErrorCode::load_failed.
  explicit LoadError(const std::string& sentence) : Error(ErrorCode::load_failed, sentence) {}
};

/// A simulation was asked for its state although a step failed, or was not brought to its end:
/// restore a state before.
class SPOKE_EXPORT StateError : public Error {
 public:
  /// ErrorCode::no_state.
  explicit StateError(const std::string& sentence) : Error(ErrorCode::no_state, sentence) {}
};

}  // namespace spoke
