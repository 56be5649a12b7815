#include "tests/graph/arithmetic_graph.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace spoke::graph::testing {
namespace {

std::vector<PartId> draw_parts(std::mt19937& random, int parts, int at_least, int at_most) {
  std::uniform_int_distribution<int> any_part(0, parts - 1);
  std::vector<PartId> drawn;
  const int count = std::uniform_int_distribution<int>(at_least, at_most)(random);
  for (int i = 0; i < count; ++i) {
    const PartId part{any_part(random)};
    if (std::find(drawn.begin(), drawn.end(), part) == drawn.end()) drawn.push_back(part);
  }
  return drawn;
}

bool contains(const std::vector<PartId>& parts, PartId part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

void run_node(GraphPlan& plan, const NodePlan& node, double salt) noexcept {
  double mixed = salt;
  for (const PartId part : node.reads) {
    for (const double value : plan.memory[static_cast<std::size_t>(part.index)]) {
      mixed = std::sin(1.3 * mixed + value);
    }
  }
  for (const PartId part : node.writes) {
    const bool in_place = contains(node.reads, part);
    for (double& value : plan.memory[static_cast<std::size_t>(part.index)]) {
      mixed = 0.9 * mixed + 0.1 * salt;
      value = in_place ? 0.5 * value + mixed : mixed;
    }
  }
}

}  // namespace

GraphPlan make_random_plan(std::uint32_t seed, int nodes, int parts, int part_size) {
  std::mt19937 random(seed);
  GraphPlan plan;
  plan.memory.assign(static_cast<std::size_t>(parts),
                     std::vector<double>(static_cast<std::size_t>(part_size)));
  for (int i = 0; i < nodes; ++i) {
    NodePlan& node = plan.nodes.emplace_back();
    node.declared_reads = node.reads = draw_parts(random, parts, 0, 3);
    node.declared_writes = node.writes = draw_parts(random, parts, 1, 2);
  }
  reset_memory(plan);
  return plan;
}

StepGraph build_graph(GraphPlan& plan) {
  StepGraphBuilder builder;
  for (std::size_t i = 0; i < plan.memory.size(); ++i) {
    // Two ranges, since a part need not be contiguous.
    const std::span<double> all = plan.memory[i];
    builder.add_part("part " + std::to_string(i), {all.first(1), all.subspan(1)});
  }
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    const NodePlan* node = &plan.nodes[i];
    builder.add_node({"node " + std::to_string(i)}, reads(node->declared_reads),
                     writes(node->declared_writes), [&plan, node, i]() noexcept {
                       run_node(plan, *node, 0.25 + 0.01 * static_cast<double>(i));
                     });
  }
  return builder.build();
}

void reset_memory(GraphPlan& plan) {
  double value = 0.1;
  for (std::vector<double>& part : plan.memory) {
    for (double& x : part) x = value = std::fmod(value + 0.377, 1.0);
  }
}

}  // namespace spoke::graph::testing
