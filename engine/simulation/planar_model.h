#pragma once

// A rotor in the plane, as a simulation sees it.

#include "engine/simulation/simulated_model.h"

namespace spoke {

/// The model of `scenario.rotor`.
std::unique_ptr<SimulatedModel> make_planar_model(const Scenario& scenario, Formulation formulation,
                                                  const Integrator& integrator, const Loads& loads);

}  // namespace spoke
