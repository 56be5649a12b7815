#pragma once

// Modes with bounds of their number.

#include "engine/modes.h"
#include "engine/steady/linear_model.h"
#include "engine/vibration/mode_count.h"
#include "models/scenario.h"

namespace spoke::vibration {

/// Names the modes of a linear model, and finds their shapes. `linear`: of `model` at
/// `equilibrium`, made with `is_axial` but for the turning frame. The result's equilibrium has no
/// warnings. Leaves the model at the equilibrium.
ModesResult make_modes(const steady::LinearModel& linear, const steady::Equilibrium& equilibrium,
                       ModeFrame frame, const ModeCount& count, steady::SteadyModel& model);

ModesResult solve_modes(const Scenario& scenario, const SteadyState& state, ModeFrame frame,
                        const ModeCount& count);

}  // namespace spoke::vibration
