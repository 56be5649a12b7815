#pragma once

// Rotors on a support, linearised: all apart, and how they meet.

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/supported_model.h"

namespace spoke::steady {

/// As linearize(); of rotors on a support the rotors with all components of their hubs, one behind
/// the other, and LinearModel::support, see stand_on().
LinearModel linearize_machine(const Equilibrium& equilibrium, SteadyModel& model);

/// Puts rotors on their support: coordinates of the hubs become z, and their matrices those of the
/// support + J^T (those of the rotors) J. The rotors' must be along axes that stand: those of a
/// rotor at rest are.
void stand_on(const LinearSupport& support, LinearModel& rotor);

}  // namespace spoke::steady
