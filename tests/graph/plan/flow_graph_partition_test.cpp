#include "graph/plan/flow_graph_partition.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

namespace {

// Makes chains of these lengths, with nothing in common.
Plan make_chains(std::span<const int> lengths) {
  StepGraphBuilder builder;
  for (int chain = 0; chain < static_cast<int>(lengths.size()); ++chain) {
    const PartId part = builder.add_part("chain " + std::to_string(chain), {});
    for (int k = 0; k < lengths[static_cast<std::size_t>(chain)]; ++k)
      builder.add_node({"link", chain, -1, k}, reads(part), writes(part), []() noexcept {});
  }
  return plan_of_single_nodes(builder.build());
}

std::size_t different(const std::vector<int>& partition) {
  return std::set<int>(partition.begin(), partition.end()).size();
}

int edges_between_flows(const Plan& plan, const std::vector<int>& partition) {
  int count = 0;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    for (const int next : plan.successors(c)) {
      count += partition[static_cast<std::size_t>(c)] != partition[static_cast<std::size_t>(next)];
    }
  }
  return count;
}

}  // namespace

TEST_CASE("partition: one for one thread, and for few clusters") {
  const Plan large = plan_of_single_nodes(make_window(50, 3, 4));
  CHECK(different(partition_clusters(large, 1)) == 1);
  CHECK(partition_clusters(large, 1).size() == static_cast<std::size_t>(large.cluster_count()));
  CHECK(different(partition_clusters(plan_of_single_nodes(make_fan(14, 2)), 2)) == 1);
  CHECK(partition_clusters(Plan(), 2).empty());
}

TEST_CASE("partition: several for several threads, numbered without gaps") {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    GraphPlan source = make_random_plan(seed, 300, 60, 2);
    const Plan plan = plan_of_single_nodes(build_graph(source));
    for (const int threads : {2, 3, 64}) {
      const std::vector<int> partition = partition_clusters(plan, threads);
      CAPTURE(seed);
      CAPTURE(threads);
      CHECK(different(partition) == (threads == 2 ? 8 : threads == 3 ? 12 : 18));
      CHECK(*std::min_element(partition.begin(), partition.end()) == 0);
      CHECK(*std::max_element(partition.begin(), partition.end()) + 1 ==
            static_cast<int>(different(partition)));
    }
  }
}

TEST_CASE("partition: chains are not torn where they need not be") {
  const std::array lengths{23, 19, 22, 20, 18};  // of 102 clusters, for 6 flow graphs
  const Plan plan = make_chains(lengths);
  CHECK(different(partition_clusters(plan, 2)) == 6);
  CHECK(edges_between_flows(plan, partition_clusters(plan, 2)) <= 3);
  const std::array equal{17, 17, 17, 17};
  const Plan four = make_chains(equal);
  CHECK(different(partition_clusters(four, 2)) == 4);
  CHECK(edges_between_flows(four, partition_clusters(four, 2)) == 0);
}

TEST_CASE("partition: blades of a window have their own") {
  const StepGraph graph = make_window(20, 4, 3);
  const Plan plan = plan_of_single_nodes(graph);
  const std::vector<int> partition = partition_clusters(plan, 2);
  CHECK(different(partition) == 8);
  // One cut between two steps within each subsystem.
  CHECK(edges_between_flows(plan, partition) <= 4);
}
