#pragma once

// Step graphs before a pass within a run, and with a declared access left out, to see that the
// check of declarations catches it.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/step/step_context.h"
#include "graph/step_graph.h"

namespace spoke::test {

/// Sets all progress to a pass within step 20, after work was done, as wide as one step. The second
/// iteration completes its step.
template <class World>
void set_progress(const PassControl& control, SystemContext<World>& context) {
  for (StepProgress& progress : context.data.progress) {
    progress = {};
    progress.control = control;
    progress.step = control.stage == PassControl::kEvaluateOnly ? 0 : 20;
    progress.passes = 1;
    progress.power = {3.0, 2.0};
    progress.work = 0.3;
    progress.dissipated = 0.2;
  }
  context.data.window = {20, 20, true};
  context.integrator.limits.tolerance = control.stage == 1 ? 1e9 : 0.0;
  context.integrator.limits.closing = 1e9;
}

/// The memory of all parts, to set back what a check's run has changed.
class Snapshot {
 public:
  explicit Snapshot(const graph::StepGraph& graph) : graph_(graph) {
    for (const graph::Part& part : graph.parts())
      for (const std::span<std::byte> range : part.memory)
        saved_.emplace_back(range.begin(), range.end());
  }
  void restore() const {
    auto next = saved_.begin();
    for (const graph::Part& part : graph_.parts())
      for (const std::span<std::byte> range : part.memory)
        std::copy(next->begin(), next->end(), range.begin()), ++next;
  }

 private:
  const graph::StepGraph& graph_;
  std::vector<std::vector<std::byte>> saved_;
};

/// The graph's nodes again, one declared access left out.
inline graph::StepGraph rebuild_without(const graph::StepGraph& graph, int node, graph::PartId part,
                                        bool is_read) {
  graph::StepGraphBuilder builder("blade");
  for (const graph::Part& p : graph.parts()) builder.add_part(p.name, p.memory);
  for (int n = 0; n < graph.node_count(); ++n) {
    const graph::NodeId id{n};
    std::vector<graph::PartId> reads = graph.node(id).reads, writes = graph.node(id).writes;
    if (n == node) std::erase(is_read ? reads : writes, part);
    builder.add_node(graph.node(id).label, graph::reads(reads), graph::writes(writes),
                     [&graph, id]() noexcept { graph.run_node(id); });
  }
  return builder.build();
}

}  // namespace spoke::test
