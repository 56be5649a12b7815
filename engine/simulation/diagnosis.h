#pragma once

// The sentence of a DivergenceError, and its fields.

#include <vector>

#include "engine/simulation/failure_site.h"
#include "engine/small_motions/steady/subsystem_names.h"
#include "models/error.h"
#include "models/scenario.h"

namespace spoke {

/// Returns the error with one sentence that says what left its limits, where (subsystem, body, node
/// of the graph, coordinate) and when, and what to try.
template <class World>
DivergenceError diagnose(const Scenario& scenario, const SystemContext<World>& context,
                         const std::vector<SubsystemNames>& names, const FailedStep& failed);

}  // namespace spoke
