#pragma once

// Work and span of a step graph for given costs of its nodes.

#include <span>
#include <vector>

#include "graph/step_graph.h"

namespace spoke::compare {

/// What the graph's nodes cost in all, and along the costliest path: no number of threads is faster
/// than that.
struct WorkAndSpan {
  double work = 0.0;
  double span = 0.0;
};

/// Precondition: a cost for each node.
WorkAndSpan calc_work_and_span(const graph::StepGraph& graph, std::span<const double> costs);

}  // namespace spoke::compare
