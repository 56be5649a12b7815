// Builds the graphs of empty and of busy nodes.

#include "graph/calibrate/calibration_graphs.h"

#include <utility>
#include <vector>

#include "graph/calibrate/timed_runs.h"

namespace spoke::graph {

StepGraph make_fork_joins(int count, double busy) {
  StepGraphBuilder builder;
  std::vector<PartId> before;
  for (int k = 0; k <= count; ++k) {
    const PartId join = builder.add_part("join", {});
    builder.add_node({"join"}, reads(before), writes(join), []() noexcept {});
    before.clear();
    for (int branch = 0; branch < 2 && k < count; ++branch) {
      before.push_back(builder.add_part("branch", {}));
      builder.add_node({"busy"}, reads(join), writes(before.back()), [busy]() noexcept {
        if (busy > 0.0) be_busy(busy);
      });
    }
  }
  return builder.build();
}

StepGraph make_ladder(int levels) {
  StepGraphBuilder builder;
  std::vector<PartId> before;
  for (int level = 0; level < levels; ++level) {
    std::vector<PartId> parts;
    for (int k = 0; k < 2; ++k) {
      parts.push_back(builder.add_part("rung", {}));
      builder.add_node({"rung"}, reads(before), writes(parts.back()), []() noexcept {});
    }
    before = std::move(parts);
  }
  return builder.build();
}

}  // namespace spoke::graph
