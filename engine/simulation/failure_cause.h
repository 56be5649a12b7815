#pragma once

// The most likely reason why a step failed.

#include <string>

#include "engine/simulation/failure_site.h"
#include "models/scenario.h"

namespace spoke {

/// Returns the likely cause with its numbers, and what to try.
template <class World>
std::string find_cause(const Scenario& scenario, const SystemContext<World>& context,
                       const FailedStep& failed, const FailureSite& site);

}  // namespace spoke
