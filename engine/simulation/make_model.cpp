// Chooses the world of the model of a scenario.

#include "engine/simulation/make_model.h"

#include "engine/simulation/model_on.h"

namespace spoke {

std::unique_ptr<SimulatedModel> make_model(const Scenario& scenario, Formulation formulation,
                                           const Integrator& integrator, const Loads& loads) {
  if (scenario.space)
    return std::make_unique<ModelOn<Space>>(scenario, formulation, integrator, loads);
  return std::make_unique<ModelOn<Plane>>(scenario, formulation, integrator, loads);
}

}  // namespace spoke
