#pragma once

// The classical Runge-Kutta method of order four, on q' = v, v' = a(q, v, t). A step runs the
// passes of stages 1, 2, 3 and then, at the new state, stage 0 of the next step, so that
// accelerations and reactions belong to the state that the step ends in.

#include "engine/bodies/coordinate_block.h"

namespace spoke {

struct Rk4 {
  double step = 0.0;  ///< h [s]
  /// Whether closed loops are projected: on their positions, then their rates. Further passes then
  /// stand at the step's end before stage 0, and ask for accelerations
  ///   4: a_0 that keep loops closed,  5: a_1, which would close them in h,
  ///   6: a_2, which would take their rates in h
  /// so that h^2 (a_1 - a_0) and h (a_2 - a_0), by forces of loops alone, close them.
  bool projects = false;

  static constexpr int kAtEnd = 4, kClosing = 5, kBraking = 6;  ///< those passes
  /// Returns the number of passes of a step.
  int passes() const { return projects ? kBraking + 1 : kStages; }

  static constexpr int kStages = 4;  ///< without projection
  /// Times of the stages within the step, and their weights.
  static constexpr std::array<double, kStages> nodes{0.0, 0.5, 0.5, 1.0};
  static constexpr std::array<double, kStages> weights{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

  /// Names for the history vectors of a CoordinateBlock.
  enum History { start_q, start_v, sum_q, sum_v, count };
};

/// Sets the coordinates for `stage` (1, 2, 3: within the step; 0: the step's end, start of the
/// next; with projection 4 to 6: its end before), from the accelerations of the stage before.
void advance(const Rk4& method, int stage, CoordinateBlock& block) noexcept;

}  // namespace spoke
