#pragma once

// Where a step failed, as the table shows it.

#include <cstdint>
#include <string>

#include "engine/simulation/observations.h"
#include "engine/step/step_context.h"

namespace spoke {

/// A step that failed.
struct FailedStep {
  StepOutcome outcome = StepOutcome::left_limits;
  double time = 0.0;      ///< that the step was to reach [s]
  std::int64_t step = 0;  ///< counted from 1
  Observations seen;      ///< up to the step before it; of energy_grew, in it
};

/// Progress of a subsystem whose step has failed.
const StepProgress& failed_progress(const StepTable& data);

/// The body at which a failure showed, and what was found there.
struct FailureSite {
  int subsystem = -1;
  int body = -1;
  std::string quantity;       ///< that failed there
  std::string finding;        ///< what is wrong with it
  const char* stage = "";     ///< of the graph's node that works on it
  bool has_bad_load = false;  ///< a load on it is not finite

  bool is_known() const { return subsystem >= 0; }
};

/// Finds the site in the table that a failed step has left. It is not known where the hub failed.
template <class World>
FailureSite find_site(const SystemContext<World>& context, StepOutcome outcome);

}  // namespace spoke
