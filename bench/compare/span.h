#pragma once

// Work and span of a step graph for given costs of its nodes.

#include <span>
#include <vector>

#include "graph/step_graph.h"

namespace spoke::compare {

/// Sum of the costs of all nodes (work), and of those along the costliest path (span), than which
/// no number of threads is faster.
struct WorkAndSpan {
  double work = 0.0;
  double span = 0.0;
};

/// Precondition: `costs` has one for each node.
WorkAndSpan calc_work_and_span(const graph::StepGraph& graph, std::span<const double> costs);

}  // namespace spoke::compare
