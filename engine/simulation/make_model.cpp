// Chooses the world of a scenario's model.

#include "engine/simulation/make_model.h"

#include "engine/simulation/planar_model.h"
#include "engine/simulation/spatial_model.h"

namespace spoke {

std::unique_ptr<SimulatedModel> make_model(const Scenario& scenario, Formulation formulation,
                                           const Integrator& integrator, const Loads& loads) {
  return scenario.space ? make_spatial_model(scenario, formulation, integrator, loads)
                        : make_planar_model(scenario, formulation, integrator, loads);
}

}  // namespace spoke
