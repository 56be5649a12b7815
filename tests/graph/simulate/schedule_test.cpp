#include "graph/simulate/schedule.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>
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

constexpr Overheads kNoOverheads{0.0, 0.0, 0.0};
constexpr Overheads kOverheads{2e-9, 200e-9, 1e-6};

// Counts violations of precedence and of one cluster at a time per processor.
int count_faults(const Plan& plan, const Schedule& schedule) {
  const auto slot = [&](int c) { return schedule.slots[static_cast<std::size_t>(c)]; };
  int faults = 0;
  for (int c = 0; c < plan.cluster_count(); ++c) {
    faults += slot(c).end > schedule.makespan ? 1 : 0;
    for (const int next : plan.successors(c)) faults += slot(next).start < slot(c).end ? 1 : 0;
  }
  std::vector<Slot> slots = schedule.slots;
  std::sort(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) {
    return std::tuple(a.processor, a.start, a.end) < std::tuple(b.processor, b.start, b.end);
  });
  for (std::size_t k = 1; k < slots.size(); ++k) {
    const bool same = slots[k].processor == slots[k - 1].processor;
    faults += same && slots[k].start < slots[k - 1].end ? 1 : 0;
  }
  return faults;
}

}  // namespace

TEST_CASE("simulator: one processor takes the work and the overheads") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    GraphPlan source = make_random_plan(seed, 80, 30, 2);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    const Plan plan = coarsen(graph, costs, {.max_bins = 3});
    const double expected = work_of(costs) + kOverheads.per_node * graph.node_count() +
                            kOverheads.per_cluster * plan.cluster_count();
    CHECK(simulate_work_stealing(plan, costs, 1, kOverheads).makespan ==
          approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("simulator: schedules are feasible and within Graham's bounds") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    GraphPlan source = make_random_plan(seed, 80, 60, 2);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    const Plan plan = plan_of_single_nodes(graph);
    const double work = work_of(costs);
    const double span = span_of(plan, costs);
    for (const int processors : {1, 2, 3, 7, 64}) {
      CAPTURE(seed);
      CAPTURE(processors);
      const Schedule schedule = simulate_work_stealing(plan, costs, processors, kNoOverheads);
      CHECK(count_faults(plan, schedule) == 0);
      CHECK(schedule.makespan >= std::max(span, work / processors) - 1e-12);
      CHECK(schedule.makespan <= work / processors + span + 1e-12);
      CHECK(count_faults(plan, simulate_work_stealing(plan, costs, processors, kOverheads)) == 0);
    }
  }
}

TEST_CASE("simulator: the span is the costliest path") {
  const StepGraph graph = make_fan(5, 3);
  const auto costs = equal_costs(graph, 1e-6);
  CHECK(span_of(plan_of_single_nodes(graph), costs) == approx(5e-6));
  CHECK(span_of(serial_plan(graph), costs) == approx(17e-6));
  CHECK(work_of(costs) == approx(17e-6));
}
