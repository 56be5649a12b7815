#pragma once

// At which speed a scenario's model turns steadily.

#include <optional>

#include "models/scenario.h"

namespace spoke::steady {

/// The speed that was asked for, or else the one that the drive leads to and holds, or that of a
/// hub that nothing drives at the start [rad/s]. Throws InputError if it is not finite, or if there
/// is none: a torque has no steady speed by itself.
double find_steady_speed(const Scenario& scenario, std::optional<double> asked);

}  // namespace spoke::steady
