#pragma once

// Controllers of Bladed's kind: a shared library with the function
// DISCON(avrSWAP, aviFAIL, accINFILE, avcOUTNAME, avcMSG). docs/scenario.md lists the records.

#include <memory>

#include "engine/controller.h"
#include "engine/simulation/simulated_model.h"

namespace spoke {

/// Loads the library of a scenario, for one simulation. Throws InputError that names its key.
std::shared_ptr<Controller> make_bladed_library(const Scenario& scenario, SimulatedModel& model);

}  // namespace spoke
