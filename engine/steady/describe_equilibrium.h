#pragma once

// What an equilibrium looks like.

#include "engine/equilibrium.h"
#include "engine/steady/find_equilibrium.h"

namespace spoke::steady {

/// Reads it from the model, which it leaves there.
EquilibriumResult describe(const Equilibrium& found, SteadyModel& model);

}  // namespace spoke::steady
