#pragma once

// Why a step failed, most likely.

#include <string>

#include "engine/simulation/failure_site.h"
#include "models/scenario.h"

namespace spoke {

/// The likely cause, with the numbers behind it, and what to try.
template <class World>
std::string find_cause(const Scenario& scenario, const SystemContext<World>& context,
                       const FailedStep& failed, const FailureSite& site);

}  // namespace spoke
