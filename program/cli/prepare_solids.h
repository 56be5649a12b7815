#pragma once

// What takes seconds before a model with solids is built.

#include <chrono>
#include <string>

#include "models/scenario.h"

namespace spoke::cli {

/// Shows on the terminal how far solids are made; clears the line at the end, after an error as
/// well. Does nothing where stderr is not a terminal.
class SolidProgress {
 public:
  SolidProgress() = default;
  ~SolidProgress();
  SolidProgress(const SolidProgress&) = delete;
  SolidProgress& operator=(const SolidProgress&) = delete;

  /// Shows what is being done, and how much of it is done, 0 to 1; a few times a second at most.
  void show(const std::string& step, double done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string last_;  ///< step that was shown
  Clock::time_point next_{};
};

/// Makes the constants of the solids of a scenario, which it keeps: models are then built of them.
/// `shows_progress`: on the terminal. Throws InputError.
void prepare_solids(const Scenario& scenario, bool shows_progress = true);

}  // namespace spoke::cli
