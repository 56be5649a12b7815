#pragma once

// The model of a scenario, in the plane or in space.

#include "engine/simulation/simulated_model.h"

namespace spoke {

/// Makes the model of a scenario. Throws InputError if the scenario, its loads or the formulation
/// cannot be simulated. `scenario` must outlive it.
std::unique_ptr<SimulatedModel> make_model(const Scenario& scenario, Formulation formulation,
                                           const Integrator& integrator, const Loads& loads);

}  // namespace spoke
