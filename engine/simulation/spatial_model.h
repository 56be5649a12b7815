#pragma once

// A model in space, as a simulation sees it.

#include "engine/simulation/simulated_model.h"

namespace spoke {

/// The model of `*scenario.space`. Throws InputError for what the engine does not simulate in
/// space: the dense formulations.
std::unique_ptr<SimulatedModel> make_spatial_model(const Scenario& scenario,
                                                   Formulation formulation,
                                                   const Integrator& integrator,
                                                   const Loads& loads);

}  // namespace spoke
