#pragma once

// The state-space matrices of a model in the frame that turns with its hub.

#include "engine/small_motions/steady/find_equilibrium.h"

namespace spoke::steady {

/// Makes the matrices of a model, which has outputs, about its equilibrium, at which it leaves the
/// model; LinearSystem::equilibrium is left empty. Throws InputError if the model is a rotor that
/// turns on a support, or if too many coordinates couple.
LinearSystem make_turning_system(const Scenario& scenario, const Equilibrium& equilibrium,
                                 SteadyModel& model);

}  // namespace spoke::steady
