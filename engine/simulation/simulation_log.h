#pragma once

// Log of a simulation in the logger of the program that embeds it (engine/support/log.h).

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/simulation/observations.h"
#include "engine/simulation_options.h"
#include "models/scenario.h"

namespace spoke {

/// Logs everything but choices once in the life of a simulation, even if states are restored, since
/// rollouts would repeat it without end.
class SimulationLog {
 public:
  /// Logs the size of the model, and what solves it.
  static void log_built(const Scenario& scenario, Formulation formulation, const ModelSize& size,
                        std::int64_t steps, double step_size, std::string_view executor,
                        const graph::Threads& threads);
  /// Logs that a state was restored.
  static void log_restored(const Scenario& scenario, double t, std::int64_t steps);
  /// Logs that the simulation diverged, or that a load failed.
  static void log_failure(const Scenario& scenario, const std::string& text);

  /// Returns the number of choices that the executor "auto" had made when one was last logged.
  int logged_choices() const { return logged_choices_; }
  /// Logs choice number `choices` of "auto", which may choose again.
  void log_choice(const Scenario& scenario, int choices, const std::string& description);

  /// Whether there are warnings that have not been logged.
  bool has_warnings(const Observations& seen) const {
    return (seen.first_deflection.step >= 0.0 && !is_logged(WarningKind::linear_range)) ||
           (seen.growth.step >= 0.0 && !is_logged(WarningKind::energy_growth)) ||
           (seen.error.first_step >= 0.0 && !is_logged(WarningKind::step_error)) ||
           (seen.momentum.first_step >= 0.0 && !is_logged(WarningKind::momentum)) ||
           (seen.loop.first_step >= 0.0 && !is_logged(WarningKind::singular_loop));
  }
  /// Logs the warnings, see Simulation::warnings(), that have not been logged.
  void log_warnings(const Scenario& scenario, const Observations& seen,
                    const std::vector<Warning>& warnings);

 private:
  bool is_logged(WarningKind kind) const { return is_logged_[static_cast<std::size_t>(kind)]; }
  bool& is_logged(WarningKind kind) { return is_logged_[static_cast<std::size_t>(kind)]; }

  int logged_choices_ = 0;
  std::array<bool, 6> is_logged_{};  ///< by kind of warning
};

}  // namespace spoke
