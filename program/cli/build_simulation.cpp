// Adds the name of the scenario's file to the errors of the simulation.

#include "program/cli/build_simulation.h"

#include "models/error.h"

namespace spoke::cli {

Simulation build_simulation(const std::string& file, const Scenario& scenario,
                            const SimulationOptions& options) {
  try {
    return Simulation(scenario, options);
  } catch (const InputError& error) {
    if (!error.place().key.empty()) throw;  // the program finds its place
    throw InputError(file + ": " + error.what());
  }
}

}  // namespace spoke::cli
