#include "graph/structure/transitive_reduction.h"

#include <doctest/doctest.h>

#include <random>

#include "graph/structure/reachability.h"

using namespace spoke::graph;

namespace {

using Lists = std::vector<std::vector<int>>;

Lists random_predecessors(int nodes, double density, std::mt19937& random) {
  std::bernoulli_distribution is_edge(density);
  Lists predecessors(index_of(nodes));
  for (int node = 0; node < nodes; ++node) {
    for (int before = 0; before < node; ++before) {
      if (is_edge(random)) predecessors[index_of(node)].push_back(before);
    }
  }
  return predecessors;
}

Reachability ancestors_of(const Lists& predecessors) {
  Reachability ancestors(static_cast<int>(predecessors.size()));
  for (int node = 0; node < static_cast<int>(predecessors.size()); ++node) {
    for (const int before : predecessors[index_of(node)]) ancestors.absorb(node, before);
  }
  return ancestors;
}

}  // namespace

TEST_CASE("transitive reduction: paths remain, and no edge is implied by another") {
  std::mt19937 random(7);
  struct Kind {
    int nodes;
    double density;
  };
  for (const Kind& kind : {Kind{1, 0.5}, {40, 0.3}, {80, 0.05}, {2500, 0.002}}) {
    const int nodes = kind.nodes;
    CAPTURE(nodes);
    Lists predecessors = random_predecessors(nodes, kind.density, random);
    const Reachability before = ancestors_of(predecessors);
    reduce_transitively(predecessors);
    const Reachability after = ancestors_of(predecessors);
    int lost = 0, implied = 0;
    for (int node = 0; node < nodes; ++node) {
      for (int other = 0; other < node; ++other)
        lost += before.contains(node, other) != after.contains(node, other);
      for (const int direct : predecessors[index_of(node)]) {
        for (const int other : predecessors[index_of(node)])
          implied += after.contains(other, direct);
      }
    }
    CHECK(lost == 0);
    CHECK(implied == 0);
  }
}

TEST_CASE("transitive reduction: of an edge that is there twice one remains") {
  Lists predecessors{{}, {0, 0}, {0, 1, 1}};
  reduce_transitively(predecessors);
  CHECK(predecessors == Lists{{}, {0}, {1}});
}
