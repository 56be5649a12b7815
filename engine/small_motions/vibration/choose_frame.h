#pragma once

// From where small motions of a scenario are seen unless it is asked for.

#include <optional>

#include "engine/modes.h"
#include "models/scenario.h"

namespace spoke::vibration {

/// Returns the frame that is asked for, or the usual one of the scenario: see ModeOptions.
ModeFrame choose_frame(const Scenario& scenario, std::optional<ModeFrame> asked);

}  // namespace spoke::vibration
