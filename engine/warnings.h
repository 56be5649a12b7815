#pragma once

// Warnings that make results doubtful.

#include <string>

namespace spoke {

/// What a warning is about.
enum class WarningKind {
  linear_range,   ///< a body bends beyond the range of linear elasticity in its frame
  energy_growth,  ///< the energy has grown beyond the work done
  speed_jump,     ///< the drive changes the speed within less than a few steps
};

/// What a simulation has come across that does not end it, but makes its results doubtful.
struct Warning {
  WarningKind kind = WarningKind::linear_range;  ///< what it is about
  double time = 0.0;                             ///< when it was noticed first [s]
  std::string text;  ///< one sentence, with the largest value so far and what to try
};

}  // namespace spoke
