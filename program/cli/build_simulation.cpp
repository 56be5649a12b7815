// Adds the name of the scenario's file to the errors of the simulation.

#include "program/cli/build_simulation.h"

#include "models/error.h"
#include "program/cli/prepare_solids.h"

namespace spoke::cli {

Simulation build_simulation(const std::string& file, const Scenario& scenario,
                            const SimulationOptions& options, bool shows_progress) {
  try {
    prepare_solids(scenario, shows_progress);
    return Simulation(scenario, options);
  } catch (const InputError& error) {
    if (!error.place().key.empty()) throw;  // the program finds its place
    throw InputError(file + ": " + error.what());
  }
}

}  // namespace spoke::cli
