#pragma once

// The errors that every part of the library may throw. models/error.h has those of a simulation.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "spoke/export.h"

namespace spoke {

/// What kind of thing went wrong.
enum class ErrorCode {
  bad_input,    ///< a scenario, file or argument that cannot be used
  diverged,     ///< the simulation left the range of its model
  load_failed,  ///< a load of the user's threw, or returned what the system cannot take
  no_state,     ///< a step failed, and what was asked for needs the state after it
  internal,     ///< a fault in Spoke
};

/// What all errors of this library's own have in common: a code, and what() is one sentence. No
/// other exception leaves the library but std::bad_alloc, and what a function of the caller's
/// throws.
class SPOKE_EXPORT Error : public std::runtime_error {
 public:
  /// An error of this kind, with its sentence.
  Error(ErrorCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  /// What kind of error it is.
  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

/// Where input that cannot be used stands, as far as that is known.
struct InputPlace {
  std::string file{};  ///< as it was named; empty: not known, or it stands in no file
  int line = 0;        ///< from 1; 0: not known
  int column = 0;      ///< from 1, in bytes; 0: not known
  std::string key{};   ///< path of the key, "blade.bodies"; empty: not known, or it is no key's
};

/// Input that cannot be used: one sentence naming where it stands (file:line:column where there is
/// one), the key, the value, and what was expected. The program ends with status 2.
class SPOKE_EXPORT InputError : public Error {
 public:
  /// ErrorCode::bad_input. The sentence says where it stands, too.
  explicit InputError(const std::string& sentence, InputPlace place = {})
      : Error(ErrorCode::bad_input, sentence),
        place_(std::make_shared<const InputPlace>(std::move(place))) {}
  /// Where the input stands.
  const InputPlace& place() const noexcept { return *place_; }

 private:
  std::shared_ptr<const InputPlace> place_;  // copies of an exception must not throw
};

}  // namespace spoke
