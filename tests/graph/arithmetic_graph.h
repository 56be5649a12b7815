#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/executor.h"
#include "graph/step_graph.h"

namespace spoke::graph::testing {

/// The parts that a node really accesses (by index), and those that it declares.
struct NodePlan {
  NodeLabel label;
  std::vector<PartId> reads;
  std::vector<PartId> writes;
  std::vector<PartId> declared_reads;
  std::vector<PartId> declared_writes;
};

/// A graph whose nodes do arithmetic on the parts of `memory`. Honest as planned.
struct GraphPlan {
  std::vector<std::vector<double>> memory;
  std::vector<NodePlan> nodes;
};

GraphPlan make_random_plan(std::uint32_t seed, int nodes, int parts, int part_size);

/// The shape of a step: subsystems of bodies, several passes. Unless `with_hub`, subsystems are
/// independent; with it they meet in a node of every pass.
struct StepShape {
  int subsystems;
  int bodies;
  int passes;
  bool with_hub;
};
GraphPlan make_step_plan(const StepShape& shape);

/// Builds the plan's graph; `plan` must outlive it. The bodies mix everything they read into
/// everything they write; results depend on the order of conflicting nodes.
StepGraph build_graph(GraphPlan& plan);

/// Sets the memory to the same start values each time.
void reset_memory(GraphPlan& plan);

/// Returns the memory after twenty runs from the start values, by an executor of the plan's graph.
std::vector<std::vector<double>> results_of(Executor& executor, GraphPlan& plan);

}  // namespace spoke::graph::testing
