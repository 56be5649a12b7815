#pragma once

// The step graph of a system: the nodes of a step, and their order.

#include "engine/step/step_context.h"
#include "graph/step_graph.h"

namespace spoke {

/// Builds the graph of some passes. In each, coordinates are set by the integrator, accelerations
/// evaluated there and handed back to it; at its end the progress moves on to the next pass of the
/// step or of the next step, within the context's window. A step of rk4 is four passes, one of
/// generalized_alpha as many as its iteration takes. The edges follow from the declared reads and
/// writes. Where subsystems are shared out over processes, the nodes are those of the own ones and
/// of the hub, and where all wait for the hub's acceleration, two that tell the other processes.
template <class World>
graph::StepGraph build_step_graph(SystemContext<World>& context, int passes = 1);

}  // namespace spoke
