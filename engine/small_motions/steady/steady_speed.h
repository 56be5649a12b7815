#pragma once

// The speed at which a scenario's model turns steadily.

#include <optional>

#include "models/scenario.h"

namespace spoke::steady {

/// Returns the speed that was asked for, else the one that the drive leads to and holds, else, for
/// a hub without a drive, the one at the start [rad/s]. Throws InputError if it is not finite, or
/// if there is none: a torque has no steady speed by itself.
double find_steady_speed(const Scenario& scenario, std::optional<double> asked);

}  // namespace spoke::steady
