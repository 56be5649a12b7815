#include "graph/simulate/wrap_around.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "graph/plan/coarsening.h"
#include "graph/simulate/work_stealing.h"
#include "tests/approx.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr Overheads kSome{2e-9, 200e-9, 1e-6};

// Returns per processor the clusters that it ran, by their starts, and those that cost nothing by
// number.
ProcessorLists lists_of(const Schedule& schedule) {
  ProcessorLists lists(static_cast<std::size_t>(schedule.processors));
  const auto slot = [&](int c) { return schedule.slots[static_cast<std::size_t>(c)]; };
  for (int c = 0; c < static_cast<int>(schedule.slots.size()); ++c)
    lists[static_cast<std::size_t>(slot(c).processor)].push_back(c);
  for (std::vector<int>& list : lists)
    std::stable_sort(list.begin(), list.end(), [&](int a, int b) {
      return std::pair(slot(a).start, slot(a).end) < std::pair(slot(b).start, slot(b).end);
    });
  return lists;
}

std::vector<int> sorted(const ProcessorLists& lists) {
  std::vector<int> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("order by lists: random graphs stay honoured, whatever the lists") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    GraphPlan source = make_random_plan(seed, 90, 10 + static_cast<int>(seed), 2);
    const StepGraph graph = build_graph(source);
    const auto costs = seed % 10 == 0 ? equal_costs(graph, 0.0) : random_costs(seed, graph);
    const Plan plan =
        seed % 2 == 0 ? plan_of_single_nodes(graph) : coarsen(graph, costs, {.max_bins = 3});
    for (const int processors : {1, 2, 5}) {
      CAPTURE(seed);
      CAPTURE(processors);
      const Schedule stolen = simulate_work_stealing(plan, costs, processors, kSome);
      CHECK(find_fault(order_by_lists(plan, costs, lists_of(stolen)), graph) == "");
      const ProcessorLists lists = wrap_around_lists(plan, costs, processors, kSome);
      CHECK(sorted(lists).size() == static_cast<std::size_t>(plan.cluster_count()));
      CHECK(find_fault(order_by_lists(plan, costs, lists), graph) == "");
    }
  }
}

TEST_CASE("order by lists: one processor makes one cluster") {
  GraphPlan source = make_random_plan(5, 90, 40, 2);
  const StepGraph graph = build_graph(source);
  const auto costs = random_costs(5, graph);
  const Plan plan = plan_of_single_nodes(graph);
  const Schedule schedule = simulate_work_stealing(plan, costs, 1, kSome);
  CHECK(order_by_lists(plan, costs, lists_of(schedule)).cluster_count() == 1);
}

TEST_CASE("order by lists: the makespan remains, and no edge is implied by others") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    GraphPlan source = make_random_plan(seed, 90, 40, 2);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    const Plan plan = plan_of_single_nodes(graph);
    const Overheads none{0.0, 0.0, 0.0};
    const Schedule schedule = simulate_work_stealing(plan, costs, 2, none);
    const Plan ordered = order_by_lists(plan, costs, lists_of(schedule));
    const Schedule again = simulate_work_stealing(ordered, costs, 2, none);
    CHECK(again.makespan == approx(schedule.makespan));
    for (int c = 0; c < ordered.cluster_count(); ++c) {
      CHECK(ordered.successors(c).size() <= 2);
      CHECK(ordered.predecessors(c).size() <= 2);
    }
  }
}

TEST_CASE("wrap-around: three equal chains on two processors take half as long again as one") {
  const StepGraph graph = make_window(40, 3, 4);
  const auto costs = equal_costs(graph, 0.5e-6);
  const double chain = work_of(costs) / 3.0;
  const Plan pieces = coarsen(graph, costs, {.grain = 1.0, .longest = chain / 40});
  const Plan plan = order_by_lists(pieces, costs, wrap_around_lists(pieces, costs, 2, kSome));
  // The clusters are the first chain; half of the second, before the third; the other half, after
  // the first.
  CHECK(plan.cluster_count() == 4);
  CHECK(plan.edge_count() == 3);
  CHECK(simulate_work_stealing(plan, costs, 2, kSome).makespan < 1.05 * 1.5 * chain);
}

TEST_CASE("wrap-around: chains of any number and processors get equal shares") {
  for (const int chains : {2, 3, 5, 7, 24}) {
    const StepGraph graph = make_window(40, chains, 2);
    const auto costs = equal_costs(graph, 1e-6);
    const double chain = work_of(costs) / chains;
    const Plan pieces = coarsen(graph, costs, {.grain = 1.0, .longest = chain / 40});
    for (const int processors : {2, 3, 4, 6}) {
      CAPTURE(chains);
      CAPTURE(processors);
      const Plan plan =
          order_by_lists(pieces, costs, wrap_around_lists(pieces, costs, processors, kSome));
      const Schedule schedule = simulate_work_stealing(plan, costs, processors, kSome);
      CHECK(schedule.makespan < 1.1 * std::max(work_of(costs) / processors, chain));
    }
  }
}
