#pragma once

// The state of an instance as a value, and as bytes.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/courses.h"
#include "engine/saved_state.h"

namespace spoke::fmu {

/// The states of an instance by the standard's state machine.
enum class Mode { instantiated, initialization, step, terminated, failed };

/// The value of an input.
struct InputValue {
  double value = 0.0;
  /// Whether it has been another one than the start value: until then the scenario's own course
  /// holds.
  bool is_given = false;
};

/// All that determines how an instance goes on.
struct ModelState {
  Mode mode = Mode::instantiated;
  double start_time = 0.0;            ///< of the importer's time [s]
  std::optional<double> stop_time{};  ///< likewise, if it was set
  std::vector<InputValue> inputs;
  Courses courses;  ///< in force
  SavedState simulation;
};

/// Returns a state as bytes, for any process with an FMU of this token on a machine of this kind.
std::string write_state(const ModelState& state, const std::string& token);

/// Reads such bytes, beside a simulation whose scenario has the drives of `own`. Throws InputError
/// if they are damaged or of an FMU with another token.
ModelState read_state(std::string_view bytes, const std::string& token, const Courses& own);

}  // namespace spoke::fmu
