#pragma once

#include <cstdint>

#include "engine/step_context.h"
#include "graph/executor.h"

namespace spoke {

/// What the integrator of generalized_alpha iterates to.
struct IterationLimits {
  double tolerance = 1e-10;  ///< of the last change of a coordinate [m, rad]
  int fixed = 0;             ///< number of iterations; 0: to the tolerance
  int most = 30;
};

/// How a step ended.
enum class StepOutcome {
  done,
  left_limits,    ///< a body's deformation or an acceleration is not finite or beyond its limits
  not_converged,  ///< the iteration did not reach its tolerance
};

/// Work done on the system since t = 0, by the quadrature that belongs to the method.
struct WorkDone {
  double by_drive_and_loads = 0.0;  ///< [J]; gravity's is a function of the state, see sensors
  double dissipated = 0.0;          ///< by damping [J]
};

/// Runs passes of the step graph to advance time.
class TimeStepper {
 public:
  /// context and executor must outlive the stepper.
  TimeStepper(StepContext& context, graph::Executor& executor, const IterationLimits& limits);

  /// Evaluates the accelerations at t = 0.
  StepOutcome start();
  /// Advances from t to t_next = t + h of the method.
  StepOutcome step(double t, double t_next);

  std::int64_t evaluations() const { return evaluations_; }
  const WorkDone& work() const { return work_; }

 private:
  StepOutcome step_generalized_alpha(double t_next);
  StepOutcome step_rk4(double t, double t_next);
  /// Runs one pass; false if the state left its limits.
  bool pass(double time, int stage, bool implicit);
  void add_work(double duration, const PassReport& rates);

  StepContext& context_;
  graph::Executor& executor_;
  IterationLimits limits_;
  std::int64_t evaluations_ = 0;
  WorkDone work_;
};

}  // namespace spoke
