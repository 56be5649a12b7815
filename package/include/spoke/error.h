#pragma once

// The errors that every part of the library may throw. models/error.h has those of a simulation.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "spoke/export.h"

namespace spoke {

/// The kind of an error.
enum class ErrorCode {
  bad_input,    ///< a scenario, file or argument that cannot be used
  diverged,     ///< the simulation left the range of its model
  load_failed,  ///< a load of the user's threw, or returned what the system cannot take
  no_state,     ///< a step failed, and what was asked for needs the state after it
  internal,     ///< a fault in Spoke
};

/// Base of all errors of this library: it has a code, and what() is one sentence. No other
/// exception leaves the library but std::bad_alloc and those that the caller's own functions throw.
class SPOKE_EXPORT Error : public std::runtime_error {
 public:
  /// Makes an error of a kind with its sentence.
  Error(ErrorCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  /// Returns the kind of the error.
  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

/// Place of input that cannot be used, as far as it is known.
struct InputPlace {
  std::string file{};  ///< name as it was given; empty: not known, or the input is in no file
  int line = 0;        ///< from 1; 0: not known
  int column = 0;      ///< from 1, in bytes; 0: not known
  std::string key{};   ///< path of the key, "blade.bodies"; empty: not known, or there is no key
};

/// Input that cannot be used. The sentence names its place (file:line:column where there is one),
/// the key, the value, and what was expected. The program ends with status 2.
class SPOKE_EXPORT InputError : public Error {
 public:
  /// Makes an error of the kind ErrorCode::bad_input. The sentence names the place, too.
  explicit InputError(const std::string& sentence, InputPlace place = {})
      : Error(ErrorCode::bad_input, sentence),
        place_(std::make_shared<const InputPlace>(std::move(place))) {}
  /// Returns the place of the input.
  const InputPlace& place() const noexcept { return *place_; }

 private:
  std::shared_ptr<const InputPlace> place_;  // copies of an exception must not throw
};

}  // namespace spoke
