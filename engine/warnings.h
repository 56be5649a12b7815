#pragma once

// Warnings that make results doubtful.

#include <string>

namespace spoke {

/// Subject of a warning.
enum class WarningKind {
  linear_range,   ///< a body bends beyond the range of linear elasticity in its frame
  energy_growth,  ///< the energy has grown beyond the work done
  speed_jump,     ///< a prescribed motion (drive, joints, mount) jumps within a few steps
  step_error,     ///< the step is too large for the motion
  momentum,       ///< the momentum of a free model is not kept
  singular_loop,  ///< a closed loop comes to a singular position
};

/// An observation that does not end a simulation, but makes its results doubtful.
struct Warning {
  WarningKind kind = WarningKind::linear_range;  ///< subject
  double time = 0.0;                             ///< at which it was noticed first [s]
  std::string text;  ///< one sentence, with the largest value so far and what to try
};

/// The largest estimated error of a coordinate in a step of generalized_alpha (docs/results.md);
/// rk4 has no estimate.
struct StepAccuracy {
  double error = 0.0;  ///< angle [rad], or place by a length of the model; 0: not known
  double time = 0.0;   ///< at the end of the step [s]
  std::string place;   ///< "the rotation of the hub", "blade 1 / body 2"
  double step = 0.0;   ///< step size for limits.step_error; if that is 0, the present one [s]
};

}  // namespace spoke
