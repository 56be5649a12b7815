#pragma once

// The sentence of a DivergenceError, and its fields.

#include <vector>

#include "engine/simulation/failure_site.h"
#include "engine/steady/tree_names.h"
#include "models/error.h"
#include "models/scenario.h"

namespace spoke {

/// One sentence that says what left its limits, where (subsystem, body, node of the graph,
/// coordinate), when, and what to try.
template <class World>
DivergenceError diagnose(const Scenario& scenario, const SystemContext<World>& context,
                         const std::vector<TreeNames>& names, const FailedStep& failed);

}  // namespace spoke
