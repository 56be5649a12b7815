#pragma once

#include <stdexcept>
#include <string>

#include "spoke/export.h"

namespace spoke {

/// What kind of thing went wrong.
enum class ErrorCode {
  bad_input,    ///< a scenario, file or argument that cannot be used
  diverged,     ///< the simulation left the range of its model
  load_failed,  ///< a load of the user's threw, or returned what the system cannot take
};

/// What all errors of this library's own have in common: a code, and what() is one sentence.
class SPOKE_EXPORT Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

/// Input that cannot be used: one sentence naming where it stands (file:line:column where there is
/// one), the key, the value, and what was expected. The program ends with status 2.
class SPOKE_EXPORT InputError : public Error {
 public:
  explicit InputError(const std::string& sentence) : Error(ErrorCode::bad_input, sentence) {}
};

/// A simulation that left the range of its model: one sentence naming time, step, subsystem, body,
/// node of the graph and quantity, and what to try. The program ends with status 3.
class SPOKE_EXPORT DivergenceError : public Error {
 public:
  explicit DivergenceError(const std::string& sentence) : Error(ErrorCode::diverged, sentence) {}
};

/// A load of the user's that failed: one sentence naming load, blade, time, step, and what it said.
/// The simulation stands at the end of the step before, and can be stepped again.
class SPOKE_EXPORT LoadError : public Error {
 public:
  explicit LoadError(const std::string& sentence) : Error(ErrorCode::load_failed, sentence) {}
};

}  // namespace spoke
