#pragma once

#include "engine/step_context.h"
#include "graph/step_graph.h"

namespace spoke {

/// Builds the graph of one pass: coordinates set by the integrator, accelerations evaluated there,
/// and handed back to it. A step of rk4 is four passes, one of generalized_alpha as many as its
/// iteration takes. The edges follow from the declared reads and writes.
graph::StepGraph build_step_graph(StepContext& context);

}  // namespace spoke
