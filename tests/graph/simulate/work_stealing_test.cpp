#include "graph/simulate/work_stealing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tests/approx.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr Overheads kNone{0.0, 0.0, 0.0};

// Returns per processor its clusters in the order of their starts.
std::vector<std::vector<int>> order_of(const Schedule& schedule) {
  std::vector<std::vector<int>> order(static_cast<std::size_t>(schedule.processors));
  const auto slot = [&](int c) { return schedule.slots[static_cast<std::size_t>(c)]; };
  for (int c = 0; c < static_cast<int>(schedule.slots.size()); ++c)
    order[static_cast<std::size_t>(slot(c).processor)].push_back(c);
  for (std::vector<int>& clusters : order)
    std::sort(clusters.begin(), clusters.end(),
              [&](int a, int b) { return slot(a).start < slot(b).start; });
  return order;
}

}  // namespace

TEST_CASE("work stealing: a single processor takes the clusters in depth-first order") {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    GraphPlan source = make_random_plan(seed, 80, 30, 2);
    const StepGraph graph = build_graph(source);
    const Plan plan = plan_of_single_nodes(graph);  // in serial order, which is depth first
    const auto order = order_of(simulate_work_stealing(plan, equal_costs(graph, 1e-6), 1, kNone));
    CHECK(std::is_sorted(order.front().begin(), order.front().end()));
  }
}

TEST_CASE("work stealing follows chains to their ends") {
  const StepGraph graph = make_window(50, 3, 1);
  const auto costs = equal_costs(graph, 1e-6);
  const Plan plan = plan_of_single_nodes(graph);
  const double work = work_of(costs);
  CHECK(simulate_work_stealing(plan, costs, 2, kNone).makespan == approx(work / 1.5));
  CHECK(simulate_work_stealing(plan, costs, 3, kNone).makespan == approx(work / 3.0));
}

TEST_CASE("work stealing: a thief takes the oldest in the deque, and pays for it") {
  const StepGraph graph = make_fan(3, 1);  // root, three nodes, join
  const auto costs = equal_costs(graph, 10e-6);
  const Schedule schedule =
      simulate_work_stealing(plan_of_single_nodes(graph), costs, 2, {0.0, 0.0, 4e-6});
  CHECK(schedule.slots[1].start == approx(10e-6));  // goes on with the first made ready
  CHECK(schedule.slots[3].start == approx(14e-6));  // stolen a handover later
  CHECK(schedule.slots[2].start == approx(20e-6));
  CHECK(schedule.makespan == approx(40e-6));
}

TEST_CASE("work stealing: a thief that comes too late finds the deque empty") {
  const StepGraph graph = make_fan(2, 1);
  const Plan plan = plan_of_single_nodes(graph);
  constexpr Overheads overheads{0.0, 0.0, 0.4e-6};
  const auto makespan = [&](double node) {
    return simulate_work_stealing(plan, equal_costs(graph, node), 2, overheads).makespan;
  };
  CHECK(makespan(0.09e-6) == approx(4 * 0.09e-6));  // after half a handover both were run
  // Stolen after half a handover, it starts the other half later.
  CHECK(makespan(0.3e-6) == approx(0.3e-6 + 0.4e-6 + 2 * 0.3e-6));
}

TEST_CASE("work stealing: more processors are not slower, and a root is handed out to all") {
  const StepGraph graph = make_fan(64, 1);
  const Plan plan = plan_of_single_nodes(graph);
  const auto costs = equal_costs(graph, 1e-6);
  constexpr Overheads overheads{0.0, 0.0, 1e-6};
  const auto makespan = [&](int processors) {
    return simulate_work_stealing(plan, costs, processors, overheads).makespan;
  };
  CHECK(makespan(8) < makespan(2));
  CHECK(makespan(8) > 66e-6 / 8.0 + 1e-6);
  CHECK(simulate_work_stealing(plan, costs, 8, kNone).makespan == approx(10e-6));
}
