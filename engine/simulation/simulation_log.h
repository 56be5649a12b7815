#pragma once

// What a simulation logs to the logger of the program that embeds it (engine/support/log.h).

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/simulation/observations.h"
#include "engine/simulation_options.h"
#include "models/scenario.h"

namespace spoke {

/// Logs everything but choices once in a simulation's life, also if states are restored: rollouts
/// would repeat it without end.
class SimulationLog {
 public:
  /// Its size, and what solves it.
  static void log_built(const Scenario& scenario, Formulation formulation, const ModelSize& size,
                        std::int64_t steps, double step_size, std::string_view executor,
                        const graph::Threads& threads);
  /// That a state was restored.
  static void log_restored(const Scenario& scenario, double t, std::int64_t steps);
  /// That it diverged, or a load failed.
  static void log_failure(const Scenario& scenario, const std::string& text);

  /// How many choices of the executor "auto" have been made at the last that was logged.
  int logged_choices() const { return logged_choices_; }
  /// What "auto" has chosen, its choice number `choices`: it may choose anew.
  void log_choice(const Scenario& scenario, int choices, const std::string& description);

  /// Whether there is something to warn of that has not been logged.
  bool has_warnings(const Observations& seen) const {
    return (seen.first_deflection.step >= 0.0 && !is_logged(WarningKind::linear_range)) ||
           (seen.growth.step >= 0.0 && !is_logged(WarningKind::energy_growth)) ||
           (seen.error.first_step >= 0.0 && !is_logged(WarningKind::step_error)) ||
           (seen.momentum.first_step >= 0.0 && !is_logged(WarningKind::momentum));
  }
  /// Logs those of the warnings, see Simulation::warnings(), that have not been logged.
  void log_warnings(const Scenario& scenario, const Observations& seen,
                    const std::vector<Warning>& warnings);

 private:
  bool is_logged(WarningKind kind) const { return is_logged_[static_cast<std::size_t>(kind)]; }
  bool& is_logged(WarningKind kind) { return is_logged_[static_cast<std::size_t>(kind)]; }

  int logged_choices_ = 0;
  std::array<bool, 5> is_logged_{};  ///< by kind of warning
};

}  // namespace spoke
