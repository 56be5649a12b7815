#include "graph/step_graph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "spoke/error.h"
#include "tests/contains.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/message_of.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_random_plan;

namespace {

constexpr auto nothing = []() noexcept {};

std::vector<int> indices(std::span<const NodeId> nodes) {
  std::vector<int> list;
  for (const NodeId node : nodes) list.push_back(node.index);
  return list;
}

using List = std::vector<int>;
using Matrix = std::vector<std::vector<bool>>;

bool contains(const std::vector<PartId>& parts, PartId part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

// Whether one of the nodes writes what the other accesses.
bool conflict(const Node& a, const Node& b) {
  const auto touched = [](const Node& node, PartId part) {
    return contains(node.reads, part) || contains(node.writes, part);
  };
  return std::any_of(a.writes.begin(), a.writes.end(), [&](PartId p) { return touched(b, p); }) ||
         std::any_of(b.writes.begin(), b.writes.end(), [&](PartId p) { return touched(a, p); });
}

Matrix closure(Matrix m) {
  for (std::size_t k = 0; k < m.size(); ++k) {
    for (std::size_t i = 0; i < m.size(); ++i) {
      for (std::size_t j = 0; j < m.size(); ++j) {
        if (m[i][k] && m[k][j]) m[i][j] = true;
      }
    }
  }
  return m;
}

Matrix edges_of(const StepGraph& graph) {
  const auto n = static_cast<std::size_t>(graph.node_count());
  Matrix edges(n, std::vector<bool>(n, false));
  for (std::size_t i = 0; i < n; ++i) {
    for (const NodeId next : graph.successors({static_cast<int>(i)})) {
      edges[i][static_cast<std::size_t>(next.index)] = true;
    }
  }
  return edges;
}

// Reachability must be that of all conflicts in order of insertion, no more and no less.
Matrix closure_of_conflicts(const StepGraph& graph) {
  const std::size_t n = graph.nodes().size();
  Matrix edges(n, std::vector<bool>(n, false));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      edges[i][j] = conflict(graph.nodes()[i], graph.nodes()[j]);
    }
  }
  return closure(edges);
}

bool every_edge_is_needed(const StepGraph& graph) {
  const Matrix edges = edges_of(graph);
  const Matrix reach = closure(edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < edges.size(); ++j) {
      for (std::size_t k = 0; edges[i][j] && k < edges.size(); ++k) {
        if (edges[i][k] && reach[k][j]) return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("a reader waits for the last writer, and readers do not wait for each other") {
  StepGraphBuilder builder;
  const PartId x = builder.add_part("x", {});
  const NodeId write = builder.add_node({"write"}, reads(), writes(x), nothing);
  const NodeId a = builder.add_node({"a"}, reads(x), writes(), nothing);
  const NodeId b = builder.add_node({"b"}, reads(x), writes(), nothing);
  const StepGraph graph = builder.build();
  CHECK(indices(graph.successors(write)) == List{1, 2});
  CHECK(indices(graph.predecessors(a)) == List{0});
  CHECK(indices(graph.predecessors(b)) == List{0});
  CHECK(graph.edge_count() == 2);
}

TEST_CASE("a writer waits for the readers since the last write, and for the last writer") {
  StepGraphBuilder builder;
  const PartId x = builder.add_part("x", {});
  builder.add_node({"a"}, reads(x), writes(), nothing);
  builder.add_node({"b"}, reads(x), writes(), nothing);
  const NodeId write = builder.add_node({"write"}, reads(), writes(x), nothing);
  const NodeId again = builder.add_node({"again"}, reads(), writes(x), nothing);
  const StepGraph graph = builder.build();
  CHECK(indices(graph.predecessors(write)) == List{0, 1});
  CHECK(indices(graph.predecessors(again)) == List{2});
}

TEST_CASE("updates in place form a chain, and chains of different parts are independent") {
  StepGraphBuilder builder;
  const std::array parts{builder.add_part("x", {}), builder.add_part("y", {})};
  for (int i = 0; i < 6; ++i) {
    const PartId part = parts[static_cast<std::size_t>(i % 2)];
    builder.add_node({"update", i}, reads(part), writes(part), nothing);
  }
  const StepGraph graph = builder.build();
  CHECK(graph.edge_count() == 4);
  CHECK(indices(graph.successors({0})) == List{2});
  CHECK(indices(graph.successors({1})) == List{3});
}

TEST_CASE("what a node updates in place it reads and writes") {
  StepGraphBuilder builder;
  const PartId a = builder.add_part("a", {}), b = builder.add_part("b", {}),
               c = builder.add_part("c", {});
  builder.add_node({"first"}, reads(a), updates(b, c), nothing);
  builder.add_node({"second"}, reads(b), updates(a), writes(c), nothing);
  const StepGraph graph = builder.build();
  CHECK(graph.node({0}).reads == std::vector{a, b, c});
  CHECK(graph.node({0}).writes == std::vector{b, c});
  CHECK(graph.node({1}).reads == std::vector{a, b});
  CHECK(graph.node({1}).writes == std::vector{a, c});
}

TEST_CASE("subsystems and bodies that have names are called by them") {
  const NodeNames names{"blade", {"front", "rear"}, {{"upper arm", "wheel"}}};
  CHECK(name_of({"mass", 0, 1}, names) == "front / wheel / mass");
  CHECK(name_of({"mass", 1, 1}, names) == "rear / body 2 / mass");
  CHECK(name_of({"mass", 2, 0}, names) == "blade 3 / body 1 / mass");
  CHECK(name_of({"finish"}, names) == "finish");
}

TEST_CASE("declarations mix parts and ranges of parts, sorted and without repetitions") {
  StepGraphBuilder builder;
  const PartId x = builder.add_part("x", {});
  const PartId y = builder.add_part("y", {});
  const std::vector<PartId> both{y, x};
  const NodeId node = builder.add_node({"node"}, reads(y, both), writes(both, x), nothing);
  const StepGraph graph = builder.build();
  CHECK(graph.node(node).reads == std::vector{x, y});
  CHECK(graph.node(node).writes == std::vector{x, y});
  CHECK(graph.part(y).name == "y");
  CHECK(graph.edge_count() == 0);
}

TEST_CASE("a part that was not added is refused") {
  StepGraphBuilder builder;
  CHECK_THROWS_AS(builder.add_node({"n"}, reads(PartId{0}), writes(), nothing), spoke::InputError);
  CHECK_THROWS_AS(builder.add_node({"n"}, reads(), writes(PartId{}), nothing), spoke::InputError);
}

TEST_CASE("two parts of one name are refused, and two nodes of a pass with one label") {
  const auto refused = [](const auto& add, const char* part) {
    StepGraphBuilder builder("blade");
    add(builder);
    for (int k = 0; k < 2; ++k) {  // it stays as it is
      const std::string message = spoke::test::message_of([&] { builder.build(); });
      CAPTURE(message);
      CHECK(spoke::test::contains(message, part));
    }
  };
  const auto add_node = [](StepGraphBuilder& builder, NodeLabel label) {
    return builder.add_node(std::move(label), reads(), writes(), nothing);
  };
  refused(
      [](StepGraphBuilder& builder) {
        for (const char* name : {"twist", "pose", "twist"}) builder.add_part(name, {});
      },
      "two parts are named \"twist\"");
  refused(
      [&](StepGraphBuilder& builder) {
        for (const int body : {0, 1, 0}) add_node(builder, {"inverse", 1, body});
      },
      "two nodes are named \"blade 2 / body 1 / inverse\"");
  refused(
      [&](StepGraphBuilder& builder) {
        const NodeId node = add_node(builder, {"inverse", 0, -1, 0, "rod"});
        builder.repeat_node(node, 3);
        add_node(builder, {"inverse", 0, -1, 3, "rod"});
      },
      "\"blade 1 / rod / inverse (pass 4)\"");
  // What differs in one coordinate is another node, and so is its repetition.
  StepGraphBuilder builder;
  const NodeId node = add_node(builder, {"a", 0, 0, 0, "x"});
  for (const NodeLabel& label :
       {NodeLabel{"b", 0, 0, 0, "x"}, NodeLabel{"a", 1, 0, 0, "x"}, NodeLabel{"a", 0, 1, 0, "x"},
        NodeLabel{"a", 0, 0, 0, "y"}, NodeLabel{"a", 0, 0, 1, "x"}, NodeLabel{"a", 0, 0, -1, "x"}})
    add_node(builder, label);
  builder.repeat_node(node, 2);
  CHECK(builder.build().node_count() == 8);
}

TEST_CASE("the builder is empty after building, and an empty graph is a graph") {
  StepGraphBuilder builder;
  builder.add_node({"node"}, reads(), writes(builder.add_part("x", {})), nothing);
  CHECK(builder.build().node_count() == 1);
  const StepGraph empty = builder.build();
  CHECK(empty.node_count() == 0);
  CHECK(empty.edge_count() == 0);
  CHECK(empty.parts().empty());
  CHECK(empty.serial_order().empty());
  CHECK(conflicts_are_ordered(empty));
}

TEST_CASE("names count from 1 and use the graph's word for a subsystem") {
  CHECK(name_of({"inverse", 1, 2}, "blade") == "blade 2 / body 3 / inverse");
  CHECK(name_of({"recovery", 0}) == "subsystem 1 / recovery");
  CHECK(name_of({"loop columns", 1, -1, 2, "rod"}) == "subsystem 2 / rod / loop columns (pass 3)");
  CHECK(name_of({"load", -1, 4}) == "body 5 / load");
  CHECK(name_of({"hub solve"}) == "hub solve");
  StepGraphBuilder builder("blade");
  const NodeId node = builder.add_node({"position", 2}, reads(), writes(), nothing);
  CHECK(builder.build().name_of(node) == "blade 3 / position");
}

TEST_CASE("the serial order goes depth first: blade by blade") {
  StepGraphBuilder builder;
  const PartId root = builder.add_part("root", {});
  builder.add_node({"root"}, reads(), writes(root), nothing);
  std::vector<PartId> blades;
  for (int i = 0; i < 3; ++i) blades.push_back(builder.add_part(name_of({"blade", i}), {}));
  for (int stage = 0; stage < 3; ++stage) {  // added stage by stage
    for (const PartId blade : blades) {
      builder.add_node({"stage", blade.index, -1, stage}, reads(root, blade), writes(blade),
                       nothing);
    }
  }
  builder.add_node({"join"}, reads(blades), writes(), nothing);
  const StepGraph graph = builder.build();
  CHECK(indices(graph.serial_order()) == List{0, 1, 4, 7, 2, 5, 8, 3, 6, 9, 10});
}

TEST_CASE("random graphs: reachability is that of the conflicts, and no edge is redundant") {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    GraphPlan plan = make_random_plan(seed, 40, 3 + static_cast<int>(seed % 12), 1);
    const StepGraph graph = build_graph(plan);
    CHECK(closure(edges_of(graph)) == closure_of_conflicts(graph));
    CHECK(every_edge_is_needed(graph));
    CHECK(conflicts_are_ordered(graph));
  }
}

TEST_CASE("edges are reduced over any distance, in memory that grows with the nodes") {
  // A chain; every node also reads what the first one wrote, and each 700th what the last such one
  // did, which the chain implies.
  constexpr int kNodes = 5000;
  StepGraphBuilder builder;
  const auto add_part = [&](int k) { return builder.add_part("part " + std::to_string(k), {}); };
  std::vector<PartId> parts;
  for (int k = 0; k < kNodes; ++k) parts.push_back(add_part(k));
  builder.add_node({"first"}, reads(), writes(parts[0]), nothing);
  for (std::size_t k = 1; k < kNodes; ++k)
    builder.add_node({"next", static_cast<int>(k)},
                     reads(parts[0], parts[k - 1], parts[k - 1 - (k - 1) % 700]), writes(parts[k]),
                     nothing);
  const StepGraph graph = builder.build();
  CHECK(graph.edge_count() == kNodes - 1);
  for (int k = 1; k < kNodes; ++k) CHECK(indices(graph.predecessors({k})) == List{k - 1});
}

TEST_CASE("random graphs: successors mirror predecessors, and the serial order is topological") {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    GraphPlan plan = make_random_plan(seed, 70, 12, 1);
    const StepGraph graph = build_graph(plan);
    std::vector<int> place(graph.nodes().size(), -1);
    int next = 0;
    for (const NodeId node : graph.serial_order())
      place[static_cast<std::size_t>(node.index)] = next++;
    CHECK(next == graph.node_count());
    int edges = 0;
    for (int i = 0; i < graph.node_count(); ++i) {
      for (const NodeId before : graph.predecessors({i})) {
        ++edges;
        const auto after = indices(graph.successors(before));
        CHECK(std::count(after.begin(), after.end(), i) == 1);
        CHECK(place[static_cast<std::size_t>(before.index)] < place[static_cast<std::size_t>(i)]);
      }
    }
    CHECK(edges == graph.edge_count());
  }
}

TEST_CASE("large graphs lose the edges that others imply") {
  StepGraphBuilder builder;
  const PartId root = builder.add_part("root", {});
  builder.add_node({"root"}, {}, writes(root), nothing);
  std::vector<PartId> parts;
  for (int i = 0; i < 300; ++i) parts.push_back(builder.add_part(name_of({"part", i}), {}));
  for (int layer = 0; layer < 10; ++layer) {
    for (const PartId part : parts) {
      builder.add_node({"own", part.index, -1, layer}, reads(root, part), writes(part), nothing);
    }
    builder.add_node({"all", -1, -1, layer}, reads(root, parts), writes(parts), nothing);
  }
  const StepGraph graph = builder.build();
  CHECK(graph.node_count() == 3011);
  // All edges from the root except those to the first layer are implied.
  CHECK(graph.edge_count() == 300 + 10 * 300 + 9 * 300);
}

TEST_CASE("a repeated node does the same again, after what it conflicts with, in its own pass") {
  double sum = 1.0, other = 0.0;
  StepGraphBuilder builder("blade");
  const PartId a = builder.add_part("a", {bytes_of(sum)});
  const PartId b = builder.add_part("b", {bytes_of(other)});
  const NodeId twice =
      builder.add_node({"twice", 0, -1, 0}, reads(a), writes(a), [&sum]() noexcept { sum *= 2.0; });
  const NodeId copy = builder.add_node({"copy", 1, -1, 0}, reads(a), writes(b),
                                       [&sum, &other]() noexcept { other = sum; });
  CHECK(builder.node_count() == 2);
  const NodeId again = builder.repeat_node(twice, 1);
  const StepGraph graph = builder.build();
  CHECK(graph.node_count() == 3);
  CHECK(graph.name_of(again) == "blade 1 / twice (pass 2)");
  REQUIRE(graph.predecessors(again).size() == 1);
  CHECK(graph.predecessors(again)[0] == copy);
  CHECK(conflicts_are_ordered(graph));
  for (const NodeId node : graph.serial_order()) graph.run_node(node);
  CHECK(sum == 4.0);
  CHECK(other == 2.0);
}
