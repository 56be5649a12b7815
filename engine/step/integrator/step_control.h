#pragma once

// From the end of a pass to the start of the next: whether the step is complete, what the next pass
// evaluates, and the work done on the way.

#include <limits>

#include "engine/bodies/table/step_progress.h"
#include "engine/step/integrator/method.h"

namespace spoke {

/// Limits to which generalized_alpha iterates.
struct IterationLimits {
  double tolerance = 1e-10;  ///< largest last change of a coordinate [m, rad]
  int fixed = 0;             ///< number of iterations; 0: to the tolerance
  int most = 30;
  bool relaxes = false;  ///< whether passes take shares of a change (relaxation.h)
  /// Iterates until the remaining error, by the contraction seen, is a small share of the change
  /// that the step's accelerations make, and with it of the step's own error. The tolerance then
  /// only tells which changes are small anyway, and which may be round-off.
  bool follows_error = false;
  double most_left = std::numeric_limits<double>::infinity();  ///< besides [m, rad]
  /// Most accelerations that a prediction goes on from, 1 to 3. Where wakes are those of predicted
  /// motions, three feed back what vibrations swing by: 2.
  int highest_order = 3;
  /// A last change beyond this, or a share of one, leaves closed loops open: openings that are left
  /// go with its square.
  double closing = std::numeric_limits<double>::infinity();
};

/// A method, with its coefficients and step, and the limits of its iteration.
struct Integrator {
  Method method;
  IterationLimits limits;
};
/// Returns h [s]: step n ends at n h.
double step_size(const Integrator& integrator);

/// Returns the progress at the end of step `step` (0: the start) before one pass that belongs to no
/// step: `stage` is PassControl::kEvaluateOnly or kRestart. It ends with a halt.
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

/// Returns the passes that one step usually takes: those of rk4 or of a fixed number of iterations;
/// 2 for an iteration to a tolerance.
int usual_passes(const Integrator& integrator);
/// Returns the most passes that one step may take; a step that is not complete by then has failed.
int most_passes(const Integrator& integrator);

}  // namespace spoke
