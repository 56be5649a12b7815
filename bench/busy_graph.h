#pragma once

// A graph shaped like a step whose nodes take a given time, to measure executors without mechanics.

#include <string>

#include "graph/step_graph.h"

namespace spoke::bench {

/// The shape of a step: blades of bodies.
struct StepShape {
  int blades = 0;
  int bodies = 0;  ///< per blade
  std::string name() const { return std::to_string(blades) + "x" + std::to_string(bodies); }
};

/// Makes a graph shaped like one pass of the structured formulation, whose nodes only keep their
/// processor busy for `node_seconds` each, by a fixed number of operations. It refers to no other
/// object.
graph::StepGraph make_busy_graph(const StepShape& shape, double node_seconds);

}  // namespace spoke::bench
