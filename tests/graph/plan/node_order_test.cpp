#include "graph/plan/node_order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "graph/calibrate/measuring_executor.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

namespace {

/// Whether every node stands behind those it waits for, and each once.
bool is_order(const StepGraph& graph, const std::vector<NodeId>& order) {
  std::vector<bool> ran(static_cast<std::size_t>(graph.node_count()), false);
  for (const NodeId node : order) {
    const auto before = graph.predecessors(node);
    if (!std::all_of(before.begin(), before.end(),
                     [&](NodeId other) { return ran[static_cast<std::size_t>(other.index)]; }))
      return false;
    ran[static_cast<std::size_t>(node.index)] = true;
  }
  return order.size() == ran.size() && std::find(ran.begin(), ran.end(), false) == ran.end();
}

}  // namespace

TEST_CASE("node order: chains side by side run one after the other, or level by level") {
  StepGraphBuilder builder;
  for (int chain = 0; chain < 2; ++chain) {
    const PartId part = builder.add_part("part", {});
    for (int k = 0; k < 3; ++k)
      builder.add_node({"link"}, reads(part), writes(part), []() noexcept {});
  }
  const StepGraph graph = builder.build();
  const auto indices = [&graph](NodeOrder order) {
    std::vector<int> list;
    for (const NodeId node : make_order(graph, order)) list.push_back(node.index);
    return list;
  };
  CHECK(indices(NodeOrder::serial) == std::vector{0, 1, 2, 3, 4, 5});
  CHECK(indices(NodeOrder::levels) == std::vector{0, 3, 1, 4, 2, 5});
}

TEST_CASE("node order: every node stands behind those it waits for") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    GraphPlan plan = make_random_plan(seed, 80, 30, 4);
    const StepGraph graph = build_graph(plan);
    CHECK(is_order(graph, make_order(graph, NodeOrder::serial)));
    CHECK(is_order(graph, make_order(graph, NodeOrder::levels)));
  }
}

TEST_CASE("node order: a measurement level by level computes the same") {
  GraphPlan plan = make_random_plan(5, 60, 25, 4);
  GraphPlan expected = plan;
  const StepGraph graph = build_graph(plan);
  const StepGraph expected_graph = build_graph(expected);
  MeasuringExecutor executor(graph, NodeOrder::levels);
  const auto serial = make_executor(expected_graph, ExecutorKind::serial);
  for (int run = 0; run < 4; ++run) {
    executor.run();
    serial->run();
  }
  CHECK(plan.memory == expected.memory);
  CHECK(executor.node_costs().size() == 60);
}
