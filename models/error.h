#pragma once

// Errors that end a simulation before its end.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "spoke/error.h"
#include "spoke/export.h"

namespace spoke {

/// Where and when a simulation left the range of its model, as the error's sentence names it.
struct Divergence {
  std::optional<double> time{};        ///< end of the step [s]; none: at an equilibrium
  std::optional<std::int64_t> step{};  ///< number of the step, from 1; none: at an equilibrium
  std::string subsystem{};             ///< "blade 2"; empty: none, or all
  std::string body{};                  ///< "body 3"; empty: none, or all
  std::string node{};      ///< node of the step graph, "blade 2 / body 3 / recovery"; may be empty
  std::string quantity{};  ///< "deflection v of node 4", "energy"
};

/// A simulation that left the range of its model: one sentence naming time, step, subsystem, body,
/// node of the graph and quantity, and what to try. The program ends with status 3.
class SPOKE_EXPORT DivergenceError : public Error {
 public:
  /// Makes an error of ErrorCode::diverged. The sentence also says where it happened.
  explicit DivergenceError(const std::string& sentence, Divergence divergence = {})
      : Error(ErrorCode::diverged, sentence),
        divergence_(std::make_shared<const Divergence>(std::move(divergence))) {}
  /// Returns where and when it happened.
  const Divergence& divergence() const noexcept { return *divergence_; }

 private:
  std::shared_ptr<const Divergence> divergence_;  // copies of an exception must not throw
};

/// A load function of the program that failed: one sentence naming load, blade, time and step, with
/// the message of its exception. The simulation stands at the end of the step before, and can be
/// stepped again.
class SPOKE_EXPORT LoadError : public Error {
 public:
  /// Makes an error of ErrorCode::load_failed.
  explicit LoadError(const std::string& sentence) : Error(ErrorCode::load_failed, sentence) {}
};

/// A simulation was asked for its state although a step failed, or was not brought to its end: a
/// state must be restored first.
class SPOKE_EXPORT StateError : public Error {
 public:
  /// Makes an error of ErrorCode::no_state.
  explicit StateError(const std::string& sentence) : Error(ErrorCode::no_state, sentence) {}
};

}  // namespace spoke
