// Builds the graphs of empty and of busy nodes.

#include "graph/calibrate/calibration_graphs.h"

#include <string>
#include <utility>
#include <vector>

#include "graph/calibrate/timed_runs.h"

namespace spoke::graph {

StepGraph make_fork_joins(int count, double busy) {
  StepGraphBuilder builder;
  std::vector<PartId> before;
  for (int k = 0; k <= count; ++k) {
    const PartId join = builder.add_part("join " + std::to_string(k), {});
    builder.add_node({"join", k}, reads(before), writes(join), []() noexcept {});
    before.clear();
    for (int branch = 0; branch < 2 && k < count; ++branch) {
      const NodeLabel label{"busy", k, branch};
      before.push_back(builder.add_part(name_of(label), {}));
      builder.add_node(label, reads(join), writes(before.back()), [busy]() noexcept {
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
      const NodeLabel label{"rung", level, k};
      parts.push_back(builder.add_part(name_of(label), {}));
      builder.add_node(label, reads(before), writes(parts.back()), []() noexcept {});
    }
    before = std::move(parts);
  }
  return builder.build();
}

}  // namespace spoke::graph
