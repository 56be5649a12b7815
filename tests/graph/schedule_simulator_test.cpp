#include "graph/schedule_simulator.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "graph/coarsening.h"
#include "tests/approx.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr Overheads kNone{0.0, 0.0, 0.0};
constexpr Overheads kSome{2e-9, 200e-9, 1e-6};

// Violations of precedence and of one cluster at a time per processor.
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

// All clusters in their topological order, dealt out to the processors in turns.
ProcessorLists deal(const Plan& plan, int processors) {
  ProcessorLists lists(static_cast<std::size_t>(processors));
  for (int c = 0; c < plan.cluster_count(); ++c) {
    lists[static_cast<std::size_t>(c % processors)].push_back(c);
  }
  return lists;
}

}  // namespace

TEST_CASE("simulator: one processor takes the work and the overheads") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    GraphPlan source = make_random_plan(seed, 80, 30, 2);
    const StepGraph graph = build_graph(source);
    const auto costs = random_costs(seed, graph);
    const Plan plan = coarsen(graph, costs, {.max_bins = 3});
    const double expected = work_of(costs) + kSome.per_node * graph.node_count() +
                            kSome.per_cluster * plan.cluster_count();
    const auto near = approx(expected).epsilon(1e-9);
    CHECK(simulate_list_schedule(plan, costs, 1, kSome).makespan == near);
    CHECK(simulate_work_stealing(plan, costs, 1, kSome).makespan == near);
    CHECK(simulate_lists(plan, costs, deal(plan, 1), kSome).makespan == near);
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
      for (const Schedule& schedule : {simulate_list_schedule(plan, costs, processors, kNone),
                                       simulate_work_stealing(plan, costs, processors, kNone)}) {
        CHECK(count_faults(plan, schedule) == 0);
        CHECK(schedule.makespan >= std::max(span, work / processors) - 1e-12);
        CHECK(schedule.makespan <= work / processors + span + 1e-12);
      }
      CHECK(count_faults(plan, simulate_list_schedule(plan, costs, processors, kSome)) == 0);
      CHECK(count_faults(plan, simulate_work_stealing(plan, costs, processors, kSome)) == 0);
      CHECK(count_faults(plan, simulate_lists(plan, costs, deal(plan, processors), kSome)) == 0);
    }
  }
}

TEST_CASE("simulator: a cluster on another processor than made it ready comes later") {
  const StepGraph graph = make_fan(2, 1);
  const auto costs = equal_costs(graph, 10e-6);
  const Plan plan = plan_of_single_nodes(graph);
  const Overheads overheads{0.0, 0.0, 3e-6};
  const Schedule schedule = simulate_list_schedule(plan, costs, 2, overheads);
  CHECK(schedule.slots[1].start == approx(10e-6));
  CHECK(schedule.slots[2].start == approx(13e-6));
  CHECK(schedule.makespan == approx(33e-6));
}

TEST_CASE("simulator: work stealing follows chains to their ends, a list schedule does not") {
  const StepGraph graph = make_window(50, 3, 1);
  const auto costs = equal_costs(graph, 1e-6);
  const Plan plan = plan_of_single_nodes(graph);
  const double work = work_of(costs);
  CHECK(simulate_work_stealing(plan, costs, 2, kNone).makespan == approx(work / 1.5));
  CHECK(simulate_list_schedule(plan, costs, 2, kNone).makespan == approx(work / 2.0));
  CHECK(simulate_work_stealing(plan, costs, 3, kNone).makespan == approx(work / 3.0));
}

TEST_CASE("simulator: a thief takes what was kept longest, and pays for it") {
  const StepGraph graph = make_fan(3, 1);  // root, three nodes, join
  const auto costs = equal_costs(graph, 10e-6);
  const Schedule schedule =
      simulate_work_stealing(plan_of_single_nodes(graph), costs, 2, {0.0, 0.0, 3e-6});
  CHECK(schedule.slots[3].start == approx(10e-6));  // the last made ready
  CHECK(schedule.slots[1].start == approx(13e-6));  // stolen
  CHECK(schedule.slots[2].start == approx(20e-6));
  CHECK(schedule.makespan == approx(40e-6));
}

TEST_CASE("simulator: processors that start clusters in turns contend for one place of counting") {
  const StepGraph graph = make_fan(2, 2);
  const Plan plan = plan_of_single_nodes(graph);
  const auto costs = equal_costs(graph, 1e-6);
  constexpr Overheads overheads{0.0, 0.0, 0.4e-6, 0.1e-6, 0.2e-6};  // found after 0.1 us
  CHECK(simulate_work_stealing(plan, costs, 1, overheads).makespan == approx(6e-6));
  const Schedule schedule = simulate_work_stealing(plan, costs, 2, overheads);
  // Each of the two starts that are kept first waits for the list that another processor searches.
  CHECK(schedule.slots[0].start == approx(0.1e-6));
  CHECK(schedule.slots[3].start == approx(1.2e-6));
  CHECK(schedule.slots[3].end == approx(2.2e-6));
  CHECK(schedule.slots[1].start == approx(1.5e-6));  // stolen: a handover after 1.1 us
  CHECK(schedule.slots[1].end == approx(2.6e-6));    // of which it waits to be counted
  CHECK(schedule.slots[4].end == approx(3.3e-6));    // waits for the place that the thief has
  CHECK(schedule.slots[2].end == approx(3.7e-6));
  CHECK(schedule.slots[5].end == approx(4.7e-6));  // at once: the same processor counted last
}

namespace {

// Of two processors that run a chain of empty nodes each [s].
double makespan_of_two_chains(int links, double node, const Overheads& overheads) {
  StepGraphBuilder builder;
  for (const char* chain : {"one", "other"}) {
    const PartId part = builder.add_part(chain, {});
    for (int k = 0; k < links; ++k)
      builder.add_node({chain}, reads(part), writes(part), []() noexcept {});
  }
  const StepGraph graph = builder.build();
  return simulate_work_stealing(plan_of_single_nodes(graph), equal_costs(graph, node), 2, overheads)
      .makespan;
}

}  // namespace

TEST_CASE("simulator: a place of counting lets one cluster start at a time") {
  constexpr Overheads overheads{0.0, 0.0, 0.0, 0.1e-6, 0.3e-6};
  // Of few nodes, all of which are counted in one place.
  const auto per_node = [&](double node) {
    return (makespan_of_two_chains(15, node, overheads) -
            makespan_of_two_chains(10, node, overheads)) /
           10.0;
  };
  CHECK(per_node(0.1e-6) == approx(0.3e-6).epsilon(0.01));
  CHECK(per_node(0.4e-6) == approx(0.3e-6).epsilon(0.01));
  CHECK(per_node(1e-6) == approx(0.55e-6).epsilon(0.01));  // 1 us and the wait, two at once
}

TEST_CASE("simulator: processors whose clusters are counted in different places do not wait") {
  constexpr Overheads overheads{0.0, 0.0, 0.0, 0.1e-6, 0.3e-6};
  const double links = 500, node = 0.2e-6;
  CHECK(makespan_of_two_chains(500, node, overheads) == approx(links * node).epsilon(0.01));
}

TEST_CASE("simulator: who comes late for a cluster finds it gone") {
  const StepGraph graph = make_fan(2, 1);
  const Plan plan = plan_of_single_nodes(graph);
  constexpr Overheads handover{0.0, 0.0, 0.4e-6};  // found after 0.1 us
  const auto makespan = [&](double node) {
    return simulate_work_stealing(plan, equal_costs(graph, node), 2, handover).makespan;
  };
  CHECK(makespan(0.09e-6) == approx(4 * 0.09e-6));
  // Found while the other still works, it starts a handover behind what made it ready.
  CHECK(makespan(0.2e-6) == approx(0.2e-6 + 0.4e-6 + 2 * 0.2e-6));
}

TEST_CASE("simulator: the span is the costliest path") {
  const StepGraph graph = make_fan(5, 3);
  const auto costs = equal_costs(graph, 1e-6);
  CHECK(span_of(plan_of_single_nodes(graph), costs) == approx(5e-6));
  CHECK(span_of(serial_plan(graph), costs) == approx(17e-6));
  CHECK(work_of(costs) == approx(17e-6));
}
