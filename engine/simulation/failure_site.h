#pragma once

// The site of a failed step in the table.

#include <cstdint>
#include <string>

#include "engine/simulation/observations.h"
#include "engine/step/step_context.h"

namespace spoke {

/// A step that failed.
struct FailedStep {
  StepOutcome outcome = StepOutcome::left_limits;
  double time = 0.0;      ///< time that the step was to reach [s]
  std::int64_t step = 0;  ///< counted from 1
  Observations seen;      ///< up to the step before; for energy_grew up to this step
};

/// Returns the progress of a subsystem whose step has failed.
const StepProgress& failed_progress(const StepTable& data);

/// The body at which a failure showed, and the finding there.
struct FailureSite {
  int subsystem = -1;
  int body = -1;
  std::string quantity;       ///< quantity that failed there
  std::string finding;        ///< what is wrong with the quantity
  const char* stage = "";     ///< stage of the graph's node that works on it
  bool has_bad_load = false;  ///< whether a load on the body is not finite
  bool is_loop = false;       ///< whether a loop of the subsystem has failed, from that body

  bool is_known() const { return subsystem >= 0; }
};

/// Finds the site in the table that a failed step has left. It is unknown if the hub failed.
template <class World>
FailureSite find_site(const SystemContext<World>& context, StepOutcome outcome);

}  // namespace spoke
