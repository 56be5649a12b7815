#include "tests/graph/shapes.h"

#include <random>

namespace spoke::graph::testing {
namespace {

constexpr auto nothing = []() noexcept {};

}  // namespace

StepGraph make_fan(int width, int length) {
  StepGraphBuilder builder;
  const PartId root = builder.add_part("root", {});
  builder.add_node({"root"}, {}, writes(root), nothing);
  std::vector<PartId> ends;
  for (int i = 0; i < width; ++i) {
    const PartId part = builder.add_part("part " + std::to_string(i), {});
    for (int k = 0; k < length; ++k) {
      builder.add_node({"link", i, -1, k}, reads(root, part), writes(part), nothing);
    }
    ends.push_back(part);
  }
  builder.add_node({"join"}, reads(ends), {}, nothing);
  return builder.build();
}

namespace {

// Returns the parts that the last nodes of each chain have written.
std::vector<PartId> add_blades(int steps, int blades, int bodies, StepGraphBuilder& builder) {
  std::vector<PartId> last;
  for (int i = 0; i < blades; ++i) {
    const PartId blade = builder.add_part(name_of({"blade", i}), {});
    std::vector<PartId> parts;
    for (int j = 0; j < bodies; ++j) parts.push_back(builder.add_part(name_of({"body", i, j}), {}));
    for (int step = 0; step < steps; ++step) {
      builder.add_node({"begin", i, -1, step}, reads(parts, blade), writes(blade), nothing);
      for (int j = 0; j < bodies; ++j) {
        const PartId part = parts[static_cast<std::size_t>(j)];
        builder.add_node({"body", i, j, step}, reads(blade), writes(part), nothing);
      }
      builder.add_node({"end", i, -1, step}, reads(parts, blade), writes(blade), nothing);
    }
    last.push_back(blade);
  }
  return last;
}

}  // namespace

StepGraph make_window(int steps, int blades, int bodies) {
  StepGraphBuilder builder;
  add_blades(steps, blades, bodies, builder);
  return builder.build();
}

StepGraph make_ended_window(int steps, int blades, int bodies) {
  StepGraphBuilder builder;
  const std::vector<PartId> last = add_blades(steps, blades, bodies, builder);
  for (int i = 0; i < blades; ++i)
    builder.add_node({"samples", i}, reads(last[static_cast<std::size_t>(i)]), {}, nothing);
  builder.add_node({"record"}, reads(last), {}, nothing);
  return builder.build();
}

std::vector<double> equal_costs(const StepGraph& graph, double cost) {
  return std::vector<double>(static_cast<std::size_t>(graph.node_count()), cost);
}

std::vector<double> random_costs(std::uint32_t seed, const StepGraph& graph) {
  std::mt19937 random(seed + 1000);
  std::vector<double> costs = equal_costs(graph, 0.0);
  for (double& cost : costs) {
    if (random() % 5 != 0) cost = 1e-9 * static_cast<double>(random() % 20000);
  }
  return costs;
}

}  // namespace spoke::graph::testing
