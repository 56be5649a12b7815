#pragma once

// Natural frequencies of a model at rest, undeformed, and the step that they allow rk4.

#include "models/scenario.h"

namespace spoke::vibration {

/// Of the undamped model at rest, joints as they start, without loads and gravity.
struct RestFrequencies {
  double lowest = 0.0;   ///< that is no rigid motion; 0: nothing vibrates [rad/s]
  double highest = 0.0;  ///< likewise [rad/s]
  /// Largest step at which rk4 is stable for what lies between, with damping; dampers of joints
  /// count as if any share of the strongest were everywhere. Infinite if there is nothing [s].
  double rk4_step = 0.0;
};

/// The lowest one by the roots of the model's pencil, the highest one by a Lanczos iteration on
/// M^-1 K, tree by tree. Throws InputError like solve_modes().
RestFrequencies find_rest_frequencies(const Scenario& scenario);

}  // namespace spoke::vibration
