#include "graph/tune/plan_candidates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "graph/execute/executor_kinds.h"
#include "tests/approx.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr Overheads kSome{2e-9, 100e-9, 1e-6};

double best_speedup(const StepGraph& graph, const std::vector<double>& costs, int processors) {
  double best = 0.0;
  for (const Candidate& candidate : find_candidates(graph, costs, processors, kSome, 1))
    best = std::max(best, work_of(costs) / candidate.makespan);
  return best;
}

}  // namespace

TEST_CASE("candidates: all honour the graph and have several clusters") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    GraphPlan source = make_random_plan(seed, 90, 10 + 3 * static_cast<int>(seed), 2);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    for (const int processors : {2, 5}) {
      CAPTURE(seed);
      CAPTURE(processors);
      const auto candidates = find_candidates(graph, costs, processors, kSome, 4);
      CHECK(candidates.size() <= 4);
      CHECK(std::is_sorted(candidates.begin(), candidates.end(),
                           [](const auto& a, const auto& b) { return a.makespan < b.makespan; }));
      for (const Candidate& candidate : candidates) {
        CHECK(find_fault(candidate.plan, graph) == "");
        CHECK(candidate.plan.cluster_count() > 1);
      }
    }
  }
}

TEST_CASE("candidates: their results equal the serial ones on any number of threads") {
  GraphPlan source = make_random_plan(5, 120, 60, 4);
  const StepGraph graph = build_graph(source);
  const auto costs = random_costs(5, graph);
  const auto results = [&](Plan plan, int threads) {
    return results_of(*make_flow_graph_executor(graph, std::move(plan), threads), source);
  };
  const auto serial = results(serial_plan(graph), 1);
  for (const Candidate& candidate : find_candidates(graph, costs, 2, kSome, 6)) {
    for (const int threads : {1, 2, 3, 6, 12}) {
      CAPTURE(threads);
      CHECK(results(candidate.plan, threads) == serial);
    }
  }
}

TEST_CASE("candidates: chains that do not divide by the processors are shared equally") {
  for (const int chains : {2, 3, 5}) {
    CAPTURE(chains);
    const StepGraph graph = make_window(40, chains, 4);
    CHECK(best_speedup(graph, equal_costs(graph, 0.2e-6), 2) > 1.85);
  }
}

TEST_CASE("candidates: three chains on two processors wrap around, with ends and a record, too") {
  for (const bool ended : {false, true}) {
    CAPTURE(ended);
    const StepGraph graph = ended ? make_ended_window(40, 3, 4) : make_window(40, 3, 4);
    const auto costs = equal_costs(graph, 0.2e-6);
    double best = 0.0;
    int fewest = graph.node_count();
    for (const Candidate& candidate : find_candidates(graph, costs, 2, kSome, 2)) {
      best = std::max(best, work_of(costs) / candidate.makespan);
      fewest = std::min(fewest, candidate.plan.cluster_count());
    }
    CHECK(best > 1.9);
    CHECK(fewest <= 5);  // two whole chains, one in two halves, and the record
  }
}

TEST_CASE("candidates: nodes without cost, a chain, and no nodes leave nothing to share") {
  const StepGraph fan = make_fan(24, 10);
  CHECK(best_speedup(fan, equal_costs(fan, 0.0), 2) == 0.0);
  const StepGraph chain = make_fan(1, 50);
  CHECK(find_candidates(chain, equal_costs(chain, 1e-6), 2, kSome, 2).empty());
  CHECK(find_candidates(StepGraphBuilder().build(), {}, 2, kSome, 2).empty());
}

TEST_CASE("candidates: the dearer clusters are, the fewer the best plan has") {
  const StepGraph graph = make_window(4, 3, 4);
  const auto costs = equal_costs(graph, 2e-6);
  const auto clusters_of_best = [&](double per_cluster) {
    const auto found = find_candidates(graph, costs, 2, {2e-9, per_cluster, 500e-9}, 1);
    return found.empty() ? 1 : found.front().plan.cluster_count();
  };
  CHECK(clusters_of_best(5e-6) <= clusters_of_best(0.0));
  CHECK(clusters_of_best(50e-6) <= 4);
}

TEST_CASE("gain: a run as short as some handovers must promise more") {
  CHECK(least_gain(1.0, 1e-6) == approx(1.05).epsilon(1e-5));
  CHECK(least_gain(10e-6, 1e-6) == approx(1.25));
}
