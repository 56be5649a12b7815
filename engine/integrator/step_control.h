#pragma once

// From the end of a pass to the start of the next: whether the step is complete, what the next pass
// evaluates, and the work done on the way.

#include <limits>

#include "engine/integrator/method.h"
#include "engine/table/step_progress.h"

namespace spoke {

/// What the integrator of generalized_alpha iterates to.
struct IterationLimits {
  double tolerance = 1e-10;  ///< of the last change of a coordinate [m, rad]
  int fixed = 0;             ///< number of iterations; 0: to the tolerance
  int most = 30;
  bool relaxes = false;  ///< see relaxation.h; with a tolerance
  /// Until what is left, by the contraction seen, is a small share of the change that the step's
  /// accelerations make, and with it of the step's own error. The tolerance then only tells what is
  /// small anyway, and what may be round-off.
  bool follows_error = false;
  double most_left = std::numeric_limits<double>::infinity();  ///< besides [m, rad]
};

/// A method, with its coefficients and step, and what it iterates to.
struct Integrator {
  Method method;
  IterationLimits limits;
};
/// h [s]: step n ends at n h.
double step_size(const Integrator& integrator);

/// Progress at the end of step `step` (0: the start) before one pass that belongs to no step:
/// `stage` is PassControl::kEvaluateOnly or kRestart. It ends with a halt.
StepProgress make_progress_between_steps(const Integrator& integrator, std::int64_t step,
                                         int stage);

/// Sets the progress to the first pass of step `step`.
void begin_step(const Integrator& integrator, std::int64_t step, StepProgress& progress) noexcept;

/// Takes the report of the pass that was made, and sets the progress to the next one: of the same
/// step, or the first one of the next, halting behind the last step of the window. Afterwards
/// `progress.completed` is the step that this pass completed, if any, and `record` (written only
/// then) what it did.
void end_pass(const Integrator& integrator, const Window& window, const PassReport& report,
              StepProgress& progress, StepRecord& record) noexcept;

/// Passes that one step takes: those of rk4, or of a fixed number of iterations; of an iteration to
/// a tolerance 2, which is what it takes mostly.
int usual_passes(const Integrator& integrator);
/// Passes that one step takes at most; a step that is not complete by then has failed.
int most_passes(const Integrator& integrator);

}  // namespace spoke
