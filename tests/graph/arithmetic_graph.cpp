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

// Plans a step: the parts of hub and subsystems, and the nodes of one pass after the other.
class StepPlanner {
 public:
  explicit StepPlanner(const StepShape& shape) : shape_(shape) {
    hub_ = add_part();
    subsystems_.resize(static_cast<std::size_t>(shape.subsystems));
    for (SubsystemParts& subsystem : subsystems_) {
      subsystem.frames = add_part();
      subsystem.effective = add_part();
      for (int j = 0; j < shape.bodies; ++j) {
        subsystem.states.push_back(add_part());
        subsystem.inverses.push_back(add_part());
      }
    }
  }

  GraphPlan plan() {
    for (pass_ = 0; pass_ < shape_.passes; ++pass_) {
      if (shape_.with_hub) add_node("hub motion", -1, -1, {hub_}, {hub_});
      for (int i = 0; i < shape_.subsystems; ++i) add_inertia(i);
      if (shape_.with_hub) add_node("hub solve", -1, -1, effective_of_all(), {hub_});
      for (int i = 0; i < shape_.subsystems; ++i) add_recovery(i);
    }
    return std::move(plan_);
  }

 private:
  using Parts = std::vector<PartId>;
  struct SubsystemParts {
    PartId frames;
    PartId effective;
    Parts states;    // per body
    Parts inverses;  // per body
  };

  PartId add_part() {
    plan_.memory.emplace_back(3);
    return {static_cast<int>(plan_.memory.size()) - 1};
  }
  void add_node(const char* stage, int subsystem, int body, const Parts& reads,
                const Parts& writes) {
    plan_.nodes.push_back({{stage, subsystem, body, pass_}, reads, writes, reads, writes});
  }
  Parts with_hub(Parts parts) const {
    if (shape_.with_hub) parts.push_back(hub_);
    return parts;
  }
  Parts effective_of_all() const {
    Parts parts;
    for (const SubsystemParts& subsystem : subsystems_) parts.push_back(subsystem.effective);
    return parts;
  }

  void add_inertia(int i) {
    const SubsystemParts& parts = subsystems_[static_cast<std::size_t>(i)];
    add_node("position", i, -1, with_hub(parts.states), {parts.frames});
    for (std::size_t j = 0; j < parts.states.size(); ++j)
      add_node("mass", i, static_cast<int>(j), {parts.frames, parts.states[j]},
               {parts.inverses[j]});
    for (std::size_t j = 0; j < parts.states.size(); ++j)
      add_node("inverse", i, static_cast<int>(j), {parts.inverses[j]}, {parts.inverses[j]});
    add_node("effective", i, -1, parts.inverses, {parts.effective});
  }
  void add_recovery(int i) {
    const SubsystemParts& parts = subsystems_[static_cast<std::size_t>(i)];
    add_node("multipliers", i, -1, with_hub({parts.effective}), {parts.effective});
    for (std::size_t j = 0; j < parts.states.size(); ++j)
      add_node("recovery", i, static_cast<int>(j), {parts.effective, parts.states[j]},
               {parts.states[j]});
  }

  StepShape shape_;
  PartId hub_;
  std::vector<SubsystemParts> subsystems_;
  int pass_ = 0;
  GraphPlan plan_;
};

}  // namespace

GraphPlan make_step_plan(const StepShape& shape) {
  GraphPlan plan = StepPlanner(shape).plan();
  reset_memory(plan);
  return plan;
}

GraphPlan make_random_plan(std::uint32_t seed, int nodes, int parts, int part_size) {
  std::mt19937 random(seed);
  GraphPlan plan;
  plan.memory.assign(static_cast<std::size_t>(parts),
                     std::vector<double>(static_cast<std::size_t>(part_size)));
  for (int i = 0; i < nodes; ++i) {
    NodePlan& node = plan.nodes.emplace_back();
    node.label.stage = "node " + std::to_string(i);
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
    builder.add_part("part " + std::to_string(i),
                     {bytes_of(all.first(1)), bytes_of(all.subspan(1))});
  }
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    const NodePlan* node = &plan.nodes[i];
    builder.add_node(node->label, reads(node->declared_reads), writes(node->declared_writes),
                     [&plan, node, i]() noexcept {
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

std::vector<std::vector<double>> results_of(Executor& executor, GraphPlan& plan) {
  reset_memory(plan);
  for (int run = 0; run < 20; ++run) executor.run();
  return plan.memory;
}

}  // namespace spoke::graph::testing
