#include "graph/work_stealing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/approx.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr Overheads kNone{0.0, 0.0, 0.0};

// Per processor its clusters in the order of their starts.
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

TEST_CASE("work stealing follows chains to their ends, a list schedule does not") {
  const StepGraph graph = make_window(50, 3, 1);
  const auto costs = equal_costs(graph, 1e-6);
  const Plan plan = plan_of_single_nodes(graph);
  const double work = work_of(costs);
  CHECK(simulate_work_stealing(plan, costs, 2, kNone).makespan == approx(work / 1.5));
  CHECK(simulate_list_schedule(plan, costs, 2, kNone).makespan == approx(work / 2.0));
  CHECK(simulate_work_stealing(plan, costs, 3, kNone).makespan == approx(work / 3.0));
}

TEST_CASE("work stealing: a thief takes what was kept longest, and pays for it") {
  const StepGraph graph = make_fan(3, 1);  // root, three nodes, join
  const auto costs = equal_costs(graph, 10e-6);
  const Schedule schedule =
      simulate_work_stealing(plan_of_single_nodes(graph), costs, 2, {0.0, 0.0, 4e-6});
  // It looks every 4 us, 2 us after the start for the first time. The rest of a handover, 2 us,
  // passes until what it takes is there.
  const double stolen = 2e-6 + 2 * 4e-6 + 2e-6;
  CHECK(schedule.slots[1].start == approx(10e-6));  // the last made ready
  CHECK(schedule.slots[3].start == approx(stolen));
  CHECK(schedule.slots[2].start == approx(20e-6));
  CHECK(schedule.makespan == approx(40e-6));
}

TEST_CASE("work stealing: who comes late for a cluster finds it gone") {
  const StepGraph graph = make_fan(2, 1);
  const Plan plan = plan_of_single_nodes(graph);
  constexpr Overheads overheads{0.0, 0.0, 0.4e-6};  // looks after 0.2, 0.6 us, ...
  const auto makespan = [&](double node) {
    return simulate_work_stealing(plan, equal_costs(graph, node), 2, overheads).makespan;
  };
  CHECK(makespan(0.09e-6) == approx(4 * 0.09e-6));
  // Found while the other still works, it starts the rest of a handover behind that.
  CHECK(makespan(0.2e-6) == approx(0.2e-6 + 0.2e-6 + 2 * 0.2e-6));
}

TEST_CASE("work stealing: a processor looks at one of the others at a time") {
  // A root makes many ready: of seven others, who all look at any one, most come too late.
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

TEST_CASE("work stealing: who keeps clusters takes longer for them") {
  Overheads overheads = kNone;
  overheads.keeping = 0.5e-6;
  const StepGraph fan = make_fan(3, 1);  // two of three are kept, and the root
  CHECK(simulate_work_stealing(plan_of_single_nodes(fan), equal_costs(fan, 1e-6), 1, overheads)
            .makespan == approx(5e-6 + 3 * 0.5e-6));
}

TEST_CASE("work stealing: a list that another processor has looked at has to come back") {
  Overheads overheads{0.0, 0.0, 8e-6};  // looks after 4, 12, 20 us, ...
  const StepGraph graph = make_fan(3, 1);
  const Plan plan = plan_of_single_nodes(graph);
  const auto costs = equal_costs(graph, 10e-6);
  const auto makespan = [&](double contention) {
    overheads.contention = contention;
    return simulate_work_stealing(plan, costs, 2, overheads).makespan;
  };
  CHECK(makespan(0.0) == approx(40e-6));
  // At the start of the run; when three are made ready, for the other has looked; when the first of
  // these ends, for the other has taken one. Then it also waits to be counted, behind the thief.
  CHECK(makespan(1e-6) == approx(44e-6));
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

TEST_CASE("work stealing: a place of counting lets one cluster start at a time") {
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

TEST_CASE("work stealing: who counts in different places does not wait") {
  constexpr Overheads overheads{0.0, 0.0, 0.0, 0.1e-6, 0.3e-6};
  const double links = 500, node = 0.2e-6;
  CHECK(makespan_of_two_chains(500, node, overheads) == approx(links * node).epsilon(0.01));
}

TEST_CASE("work stealing: a stolen cluster waits for its data") {
  // One writer, then two readers of its data on two processors.
  alignas(64) std::array<double, 1000> memory{};
  StepGraphBuilder builder;
  const PartId data = builder.add_part("data", {memory});
  builder.add_node({"write"}, {}, writes(data), []() noexcept {});
  for (int k = 0; k < 2; ++k) builder.add_node({"read"}, reads(data), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  const std::array costs{1e-6, 10e-6, 10e-6};
  const Plan plan = plan_of_single_nodes(graph);
  DataTraffic traffic(graph, {0.0, 1e-9});
  const auto makespan = [&](DataTraffic* data_traffic) {
    return simulate_work_stealing(plan, costs, 2, kNone, data_traffic).makespan;
  };
  CHECK(makespan(nullptr) == approx(11e-6));
  CHECK(makespan(&traffic) == approx(19e-6));
}

TEST_CASE("work stealing: by chance waits are longer and shorter, about what they are without") {
  const StepGraph graph = make_window(20, 3, 4);
  const Plan plan = plan_of_single_nodes(graph);
  const auto costs = equal_costs(graph, 0.5e-6);
  constexpr Overheads overheads{2e-9, 40e-9, 0.6e-6, 70e-9, 130e-9};
  Chance chance;
  std::vector<double> makespans;
  for (int k = 0; k < 50; ++k)
    makespans.push_back(
        simulate_work_stealing(plan, costs, 2, overheads, nullptr, &chance).makespan);
  const double least = *std::min_element(makespans.begin(), makespans.end());
  const double most = *std::max_element(makespans.begin(), makespans.end());
  const double without = simulate_work_stealing(plan, costs, 2, overheads).makespan;
  // Waits are a part of it, and not all of them are short, or long, at once.
  CHECK(least < most);
  CHECK(least > 0.8 * without);
  CHECK(most < 1.2 * without);
}
