#pragma once

// Modes with bounds of their number.

#include <optional>

#include "engine/modes.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/mode_count.h"
#include "models/scenario.h"

namespace spoke::vibration {

/// Names the modes of a linear model, and finds their shapes. `linear`: of `model` at
/// `equilibrium`, made with `is_axial` but for the turning frame. `whole`: for `floquet` the same
/// with `is_whole`; null: what turns against the hub does not count. The result's equilibrium has
/// no warnings. Leaves the model at the equilibrium.
ModesResult make_modes(const steady::LinearModel& linear, const steady::Equilibrium& equilibrium,
                       ModeFrame frame, const ModeCount& count, steady::SteadyModel& model,
                       steady::SteadyModel* whole = nullptr);

ModesResult solve_modes(const Scenario& scenario, const SteadyState& state,
                        std::optional<ModeFrame> frame, const ModeCount& count);

}  // namespace spoke::vibration
