#pragma once

// A rotor on a support, linearised: both apart, and how they meet.

#include "engine/steady/linear_model.h"
#include "engine/steady/supported_model.h"

namespace spoke::steady {

/// As linearize(): the rotor with all components of its hub, and LinearModel::support.
LinearModel linearize_on(SupportedModel& model, const Equilibrium& equilibrium);

}  // namespace spoke::steady
