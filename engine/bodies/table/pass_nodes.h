#pragma once

// The pass of a graph to which nodes are added.

#include <string>
#include <vector>

#include "engine/bodies/table/step_progress.h"
#include "graph/step_graph.h"

namespace spoke {

using PartList = std::vector<graph::PartId>;

/// The builder of a graph, and the pass that the added nodes belong to.
struct PassNodes {
  graph::StepGraphBuilder& builder;
  double step = 0.0;  ///< time step [s]
  int pass = -1;      ///< -1: the only one

  graph::NodeLabel label(const char* stage, int subsystem = -1, int body = -1) const {
    return {stage, subsystem, body, pass};
  }
  graph::NodeLabel label_item(const char* stage, int subsystem, const std::string& item) const {
    return {stage, subsystem, -1, pass, item};
  }
};

/// Makes the body of a node that has nothing to do while its progress is halted.
template <class Body>
auto unless_halted(const StepProgress& progress, Body body) {
  return [&progress, body]() noexcept {
    if (!progress.is_halted) body();
  };
}

}  // namespace spoke
