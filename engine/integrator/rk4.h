#pragma once

// The classical Runge-Kutta method of order four, on q' = v, v' = a(q, v, t). A step runs the
// passes of stages 1, 2, 3 and then, at the new state, stage 0 of the next step, so that
// accelerations and reactions belong to the state that the step ends in.

#include "engine/body/coordinate_block.h"

namespace spoke {

struct Rk4 {
  double step = 0.0;  ///< h [s]

  static constexpr int kStages = 4;
  /// Times of the stages within the step, and their weights.
  static constexpr std::array<double, kStages> nodes{0.0, 0.5, 0.5, 1.0};
  static constexpr std::array<double, kStages> weights{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

  /// Names for the history vectors of a CoordinateBlock.
  enum History { start_q, start_v, sum_q, sum_v, count };
};

/// Sets the coordinates for `stage` (1, 2, 3: within the step; 0: the step's end, start of the
/// next), from the accelerations of the stage before.
void advance(const Rk4& method, int stage, CoordinateBlock& block) noexcept;

}  // namespace spoke
