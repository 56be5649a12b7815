#include "graph/plan/level_rounds.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

namespace {

using List = std::vector<int>;

std::vector<std::vector<List>> indices(const std::vector<Round>& rounds) {
  std::vector<std::vector<List>> result;
  for (const Round& round : rounds) {
    auto& threads = result.emplace_back();
    for (const auto& nodes : round) {
      List& list = threads.emplace_back();
      for (const NodeId node : nodes) list.push_back(node.index);
    }
  }
  return result;
}

// Makes, per column of `width` nodes: a node, and one that waits for it; then one that waits for
// all.
StepGraph two_rows_and_a_join(int width) {
  StepGraphBuilder builder;
  std::vector<PartId> parts;
  for (int i = 0; i < width; ++i)
    parts.push_back(builder.add_part("part " + std::to_string(i), {}));
  for (int row = 0; row < 2; ++row)
    for (const PartId part : parts)
      builder.add_node({"node", part.index, -1, row}, reads(part), writes(part), []() noexcept {});
  builder.add_node({"join"}, reads(parts), writes(), []() noexcept {});
  return builder.build();
}

}  // namespace

TEST_CASE("levels are shared out evenly, with a barrier only where an edge crosses threads") {
  const auto rounds = indices(derive_level_rounds(two_rows_and_a_join(4), 2));
  REQUIRE(rounds.size() == 2);
  CHECK(rounds[0] == std::vector<List>{{0, 1, 4, 5}, {2, 3, 6, 7}});
  CHECK(rounds[1] == std::vector<List>{{8}, {}});
}

TEST_CASE("one thread needs no barrier, and threads beyond the nodes have nothing to do") {
  CHECK(derive_level_rounds(two_rows_and_a_join(3), 1).size() == 1);
  const auto rounds = indices(derive_level_rounds(two_rows_and_a_join(1), 3));
  REQUIRE(rounds.size() == 1);
  CHECK(rounds[0] == std::vector<List>{{0, 1, 2}, {}, {}});
  CHECK(derive_level_rounds(StepGraphBuilder().build(), 2).empty());
}
