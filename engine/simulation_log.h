#pragma once

// What a simulation says to the logger of the program that embeds it (engine/log.h).

#include <string>

#include "engine/observations.h"
#include "engine/simulation.h"

namespace spoke {

/// Says everything but choices once in a simulation's life, also if states are restored: rollouts
/// would repeat it without end.
class SimulationLog {
 public:
  /// Its size, and what solves it.
  static void tell_built(const Simulation& simulation);
  /// That a state was restored.
  static void tell_restored(const Scenario& scenario, double t, std::int64_t steps);
  /// That it diverged, or a load failed.
  static void tell_failure(const Scenario& scenario, const std::string& text);

  /// How many choices of the executor "auto" have been made at the last that was told.
  int told_choices() const { return told_choices_; }
  /// What "auto" has chosen, its choice number `choices`: it chooses anew when it doubts.
  void tell_choice(const Scenario& scenario, int choices, const std::string& description);

  /// Whether there is something to warn of that has not been told.
  bool has_warnings(const Observations& seen) const {
    return (seen.first_bend.step >= 0.0 && !has_told_bend_) ||
           (seen.growth.step >= 0.0 && !has_told_growth_);
  }
  /// Tells it, as Simulation::warnings() does.
  void tell_warnings(const Scenario& scenario, double step_size, const Observations& seen);

 private:
  int told_choices_ = 0;
  bool has_told_bend_ = false, has_told_growth_ = false;
};

}  // namespace spoke
