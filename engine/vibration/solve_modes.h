#pragma once

// Modes, as many as there are within bounds.

#include "engine/modes.h"
#include "models/scenario.h"

namespace spoke::vibration {

/// How many modes are wanted, of each blade where blades do not couple.
struct ModeCount {
  int least = 0;  ///< InputError if there are fewer
  int most = 10;
};

ModesResult solve_modes(const Scenario& scenario, const SteadyState& state, const ModeCount& count);

}  // namespace spoke::vibration
