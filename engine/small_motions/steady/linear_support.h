#pragma once

// A rotor on a support, linearised: both apart, and how they meet.

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/supported_model.h"

namespace spoke::steady {

/// As linearize(); of a rotor on a support the rotor with all components of its hub, and
/// LinearModel::support, see stand_on().
LinearModel linearize_machine(const Equilibrium& equilibrium, SteadyModel& model);

/// Puts a rotor on its support: coordinates of the hub become z, and its matrices those of the
/// support + J^T (those of the rotor) J. The rotor's must be along axes that stand: those of a
/// rotor at rest are.
void stand_on(const LinearSupport& support, LinearModel& rotor);

}  // namespace spoke::steady
