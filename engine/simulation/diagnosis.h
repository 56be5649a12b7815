#pragma once

// The sentence of a DivergenceError, and its fields.

#include <cstdint>

#include "engine/simulation/observations.h"
#include "engine/step/step_context.h"
#include "models/error.h"
#include "models/scenario.h"

namespace spoke {

/// Where a step failed.
struct FailedStep {
  StepOutcome outcome = StepOutcome::left_limits;
  double time = 0.0;      ///< that the step was to reach [s]
  std::int64_t step = 0;  ///< counted from 1
  Observations seen;      ///< up to the step before it; of energy_grew, in it
};

/// Progress of a subsystem whose step has failed.
const StepProgress& failed_progress(const StepTable& data);

/// One sentence that says what left its limits, where (blade, body, node of the graph, coordinate),
/// when, and what to try.
DivergenceError diagnose(const Scenario& scenario, const SystemContext<Plane>& context,
                         const FailedStep& failed);

}  // namespace spoke
