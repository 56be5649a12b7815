#pragma once

// Modes with bounds of their number.

#include "engine/modes.h"
#include "engine/steady/linear_model.h"
#include "models/scenario.h"

namespace spoke::vibration {

/// Number of modes that are wanted, of each subsystem where subsystems do not couple.
struct ModeCount {
  int least = 0;  ///< solve_modes() throws InputError if there are fewer
  int most = 10;
};

/// Names the modes of a linear model, and finds their shapes. `linear`: of `model` at
/// `equilibrium`. The result's equilibrium has no warnings. Leaves the model at the equilibrium.
ModesResult make_modes(const steady::LinearModel& linear, const steady::Equilibrium& equilibrium,
                       const ModeCount& count, steady::SteadyModel& model);

ModesResult solve_modes(const Scenario& scenario, const SteadyState& state, const ModeCount& count);

}  // namespace spoke::vibration
