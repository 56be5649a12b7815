#include "graph/plan/plan.h"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "graph/execute/executor_kinds.h"
#include "graph/plan/coarsening.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::equal_costs;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_ended_window;
using spoke::graph::testing::make_fan;
using spoke::graph::testing::make_random_plan;
using spoke::graph::testing::random_costs;

namespace {

std::vector<int> sizes(const Plan& plan) {
  std::vector<int> list;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    list.push_back(static_cast<int>(plan.nodes(c).size()));
  }
  return list;
}

}  // namespace

TEST_CASE("plans: single nodes and serial hold every node and honour every edge") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    GraphPlan source = make_random_plan(seed, 60, 3 + static_cast<int>(seed), 2);
    const StepGraph graph = build_graph(source);
    const Plan single = plan_of_single_nodes(graph);
    CHECK(find_fault(single, graph) == "");
    CHECK(single.cluster_count() == graph.node_count());
    CHECK(single.edge_count() == graph.edge_count());
    const Plan serial = serial_plan(graph);
    CHECK(find_fault(serial, graph) == "");
    CHECK(serial.cluster_count() == 1);
  }
}

TEST_CASE("plans: of an empty graph") {
  const StepGraph graph = StepGraphBuilder().build();
  CHECK(serial_plan(graph).cluster_count() == 0);
  CHECK(plan_of_single_nodes(graph).cluster_count() == 0);
  CHECK(coarsen(graph, {}, {}).cluster_count() == 0);
}

TEST_CASE("plans: faults are found") {
  const StepGraph graph = make_fan(2, 1);  // 0 -> 1, 2 -> 3
  const auto fault = [&](const std::vector<std::vector<int>>& lists, bool linked) {
    CompressedRows<NodeId> clusters;
    CompressedRows<int> successors;
    for (std::size_t c = 0; c < lists.size(); ++c) {
      for (const int node : lists[c]) clusters.push_back({node});
      clusters.end_row();
      if (linked && c + 1 < lists.size()) successors.push_back(static_cast<int>(c) + 1);
      successors.end_row();
    }
    return find_fault(Plan(std::move(clusters), std::move(successors)), graph);
  };
  CHECK(fault({{0}, {1, 2}, {3}}, true) == "");
  CHECK(fault({{0}, {1, 2}, {3}}, false) == "edge from node 0 to 1");
  CHECK(fault({{0, 1, 3, 2}}, true) == "edge from node 2 to 3");
  CHECK(fault({{0, 1, 1, 3}}, true) == "node 1 twice");
  CHECK(fault({{0, 1, 2}}, true) == "number of nodes");
}

TEST_CASE("plans: the level width") {
  CHECK(level_width(plan_of_single_nodes(make_fan(6, 3))) == 6);
  CHECK(level_width(plan_of_single_nodes(make_fan(1, 3))) == 1);
  CHECK(level_width(serial_plan(make_fan(6, 3))) == 1);
  CHECK(level_width(Plan()) == 0);
}

TEST_CASE("coarsening: chains become one cluster, siblings of little cost too") {
  const StepGraph graph = make_fan(6, 3);
  const auto costs = equal_costs(graph, 1e-6);
  CHECK(sizes(coarsen(graph, costs, {})) == std::vector{1, 3, 3, 3, 3, 3, 3, 1});
  CHECK(sizes(coarsen(graph, costs, {.max_bins = 2})) == std::vector{1, 9, 9, 1});
  CHECK(sizes(coarsen(graph, costs, {.grain = 6e-6})) == std::vector{1, 6, 6, 6, 1});
  CHECK(sizes(coarsen(graph, costs, {.grain = 1.0})) == std::vector{20});
  CHECK(sizes(coarsen(graph, equal_costs(graph, 0.0), {})) == std::vector{20});
}

TEST_CASE("coarsening: the longest cluster cuts chains into pieces") {
  const StepGraph graph = make_fan(1, 98);
  const auto costs = equal_costs(graph, 1e-6);
  CHECK(sizes(coarsen(graph, costs, {})) == std::vector{100});
  CHECK(sizes(coarsen(graph, costs, {.longest = 30.5e-6})) == std::vector{30, 30, 30, 10});
}

TEST_CASE("coarsening: cheap ends join the cluster that they wait for") {
  // 8 nodes per subsystem, its end, and a record.
  const StepGraph graph = make_ended_window(2, 3, 2);
  auto costs = equal_costs(graph, 1e-6);
  CHECK(sizes(coarsen(graph, costs, {.grain = 3e-6})) == std::vector{9, 9, 9, 1});
  for (std::size_t k = 24; k < 27; ++k) costs[k] = 10e-6;
  CHECK(sizes(coarsen(graph, costs, {.grain = 3e-6})) == std::vector{8, 1, 8, 1, 8, 1, 1});
}

TEST_CASE("coarsening: random graphs with random costs stay honoured") {
  const std::array<CoarseningOptions, 6> all{{{},
                                              {.grain = 5e-6},
                                              {.grain = 50e-6, .max_bins = 4},
                                              {.max_bins = 2},
                                              {.grain = 20e-6, .max_bins = 3, .longest = 40e-6},
                                              {.grain = 1.0}}};
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    GraphPlan source = make_random_plan(seed, 90, 5 + static_cast<int>(seed % 40), 2);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    for (const CoarseningOptions& options : all) {
      CAPTURE(seed);
      CAPTURE(options.grain);
      const Plan plan = coarsen(graph, costs, options);
      CHECK(find_fault(plan, graph) == "");
      CHECK(plan.cluster_count() < graph.node_count());
    }
  }
}

TEST_CASE("flow graph of a plan: results equal the serial ones") {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    GraphPlan source = make_random_plan(seed, 90, 40, 4);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    const auto results = [&](Plan plan, int threads) {
      return results_of(*make_flow_graph_executor(graph, std::move(plan), threads), source);
    };
    const auto serial = results(serial_plan(graph), 1);
    for (const int threads : {1, 2, 3, 6, 12}) {
      CAPTURE(seed);
      CAPTURE(threads);
      CHECK(results(coarsen(graph, costs, {.max_bins = 3}), threads) == serial);
      CHECK(results(coarsen(graph, costs, {.grain = 30e-6}), threads) == serial);
    }
  }
}

TEST_CASE("flow graph of a plan: wherever clusters are counted, results equal the serial ones") {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    GraphPlan source = make_random_plan(seed, 90, 40, 4);
    const StepGraph graph = build_graph(source);
    const auto serial = results_of(*make_serial_executor(graph), source);
    std::mt19937 random(seed);
    for (const int place_count : {1, 2, 7, 90}) {
      CAPTURE(seed);
      CAPTURE(place_count);
      std::vector<int> places(90);
      for (int c = 0; c < 90; ++c) {  // each place has a cluster
        places[static_cast<std::size_t>(c)] =
            c < place_count ? c : static_cast<int>(random() % static_cast<unsigned>(place_count));
      }
      const auto executor =
          make_flow_graph_executor(graph, plan_of_single_nodes(graph), 3, std::move(places));
      CHECK(results_of(*executor, source) == serial);
    }
  }
}
