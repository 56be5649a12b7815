#pragma once

// Modes with bounds of their number.

#include "engine/modes.h"
#include "models/scenario.h"

namespace spoke::vibration {

/// Number of modes that are wanted, of each subsystem where subsystems do not couple.
struct ModeCount {
  int least = 0;  ///< solve_modes() throws InputError if there are fewer
  int most = 10;
};

ModesResult solve_modes(const Scenario& scenario, const SteadyState& state, const ModeCount& count);

}  // namespace spoke::vibration
