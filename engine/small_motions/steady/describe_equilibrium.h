#pragma once

// Describes an equilibrium for users.

#include "engine/equilibrium.h"
#include "engine/small_motions/steady/find_equilibrium.h"

namespace spoke::steady {

/// Reads the description from the model, which it leaves at the equilibrium.
EquilibriumResult describe(const Equilibrium& found, SteadyModel& model);

}  // namespace spoke::steady
