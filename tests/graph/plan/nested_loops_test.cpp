#include "graph/plan/nested_loops.h"

#include <doctest/doctest.h>

#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

namespace {

constexpr auto nothing = []() noexcept {};

std::vector<std::string> names(const StepGraph& graph, const NodeChain& chain) {
  std::vector<std::string> list;
  for (const NodeId node : chain) list.push_back(graph.name_of(node));
  return list;
}
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a pass with a hub: loops over subsystems between what is done at the hub") {
  GraphPlan plan = make_step_plan({3, 4, 1, true});
  const StepGraph graph = build_graph(plan);
  const auto loops = derive_nested_loops(graph);
  REQUIRE(loops.size() == 2);
  CHECK(names(graph, loops[0].alone) == Names{"hub motion (pass 1)"});
  CHECK(names(graph, loops[1].alone) == Names{"hub solve (pass 1)"});
  REQUIRE(loops[0].subsystems.size() == 3);
  const SubsystemWork& work = loops[0].subsystems[1];
  REQUIRE(work.size() == 2);
  CHECK(names(graph, work[0].alone) == Names{"subsystem 2 / position (pass 1)"});
  REQUIRE(work[0].bodies.size() == 4);
  // Mass and inverse of one body are in one loop, without a barrier between.
  CHECK(names(graph, work[0].bodies[2]) ==
        Names{"subsystem 2 / body 3 / mass (pass 1)", "subsystem 2 / body 3 / inverse (pass 1)"});
  CHECK(names(graph, work[1].alone) == Names{"subsystem 2 / effective (pass 1)"});
  CHECK(work[1].bodies.empty());
}

TEST_CASE("passes of subsystems that never meet are one loop over subsystems") {
  GraphPlan plan = make_step_plan({3, 4, 5, false});
  const StepGraph graph = build_graph(plan);
  const auto loops = derive_nested_loops(graph);
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].alone.empty());
  REQUIRE(loops[0].subsystems.size() == 3);
  for (const SubsystemWork& work : loops[0].subsystems) CHECK(work.size() == 5 * 2);
}

TEST_CASE("an edge between subsystems begins a new loop over subsystems") {
  StepGraphBuilder builder;
  const PartId x = builder.add_part("x", {});
  builder.add_node({"a", 0}, reads(), writes(x), nothing);
  builder.add_node({"a", 1}, reads(), writes(), nothing);
  builder.add_node({"b", 1}, reads(x), writes(), nothing);
  const auto loops = derive_nested_loops(builder.build());
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].subsystems.size() == 2);
  CHECK(loops[1].subsystems.size() == 1);
}

TEST_CASE("an edge between bodies begins a new loop over bodies") {
  StepGraphBuilder builder;
  const PartId x = builder.add_part("x", {});
  builder.add_node({"a", 0, 0}, reads(), writes(x), nothing);
  builder.add_node({"a", 0, 1}, reads(), writes(), nothing);
  builder.add_node({"b", 0, 1}, reads(x), writes(), nothing);
  builder.add_node({"b", 0, 0}, reads(x), writes(), nothing);
  const auto loops = derive_nested_loops(builder.build());
  REQUIRE(loops.size() == 1);
  REQUIRE(loops[0].subsystems.size() == 1);
  const SubsystemWork& work = loops[0].subsystems[0];
  REQUIRE(work.size() == 2);
  CHECK(work[0].bodies.size() == 2);
  CHECK(work[1].bodies == std::vector<NodeChain>{{NodeId{3}}, {NodeId{2}}});  // by body
}

TEST_CASE("items of a body are chains of their own in the loop over bodies") {
  StepGraphBuilder builder;
  const PartId x = builder.add_part("x", {}), y = builder.add_part("y", {});
  builder.add_node({"tile", 0, 0, -1, "slice 1"}, reads(), writes(x), nothing);
  builder.add_node({"tile", 0, 0, -1, "slice 2"}, reads(), writes(y), nothing);
  builder.add_node({"sum", 0, 0}, reads(x, y), writes(x, y), nothing);
  builder.add_node({"next", 0, 0, -1, "slice 1"}, reads(x), writes(x), nothing);
  builder.add_node({"next", 0, 0, -1, "slice 2"}, reads(y), writes(y), nothing);
  const auto loops = derive_nested_loops(builder.build());
  REQUIRE(loops.size() == 1);
  const SubsystemWork& work = loops[0].subsystems[0];
  REQUIRE(work.size() == 3);
  CHECK(work[0].bodies == std::vector<NodeChain>{{NodeId{0}}, {NodeId{1}}});
  CHECK(work[1].bodies == std::vector<NodeChain>{{NodeId{2}}});
  CHECK(work[2].bodies == std::vector<NodeChain>{{NodeId{3}}, {NodeId{4}}});
}

TEST_CASE("nodes without coordinates are run alone, in the order of insertion") {
  GraphPlan plan = make_random_plan(5, 30, 10, 2);
  const auto loops = derive_nested_loops(build_graph(plan));
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].subsystems.empty());
  REQUIRE(loops[0].alone.size() == 30);
  for (int i = 0; i < 30; ++i) CHECK(loops[0].alone[static_cast<std::size_t>(i)].index == i);
  CHECK(derive_nested_loops(StepGraphBuilder().build()).empty());
}
