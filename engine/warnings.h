#pragma once

// Warnings that make results doubtful.

#include <string>

namespace spoke {

/// What a warning is about.
enum class WarningKind {
  linear_range,   ///< a body bends beyond the range of linear elasticity in its frame
  energy_growth,  ///< the energy has grown beyond the work done
  speed_jump,     ///< what is prescribed (drive, joints, mount) jumps within less than a few steps
  step_error,     ///< the step is too large for the motion
  momentum,       ///< the momentum of a free model is not kept
};

/// What a simulation has come across that does not end it, but makes its results doubtful.
struct Warning {
  WarningKind kind = WarningKind::linear_range;  ///< what it is about
  double time = 0.0;                             ///< when it was noticed first [s]
  std::string text;  ///< one sentence, with the largest value so far and what to try
};

/// The largest estimate of what a step has wrong in a coordinate, of generalized_alpha (docs/
/// results.md); rk4 has none.
struct StepAccuracy {
  double error = 0.0;  ///< of an angle [rad], of a place by a length of the model; 0: not known
  double time = 0.0;   ///< at the end of the step [s]
  std::string place;   ///< "the rotation of the hub", "blade 1 / body 2"
  double step = 0.0;   ///< that would bring it to limits.step_error, or leave it there [s]
};

}  // namespace spoke
