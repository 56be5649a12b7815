#include "graph/calibrate/node_costs.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "graph/executor.h"
#include "graph/machine/time_stamp.h"
#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

TEST_CASE("time stamps: their scale is that of the steady clock") {
  using Clock = std::chrono::steady_clock;
  const double scale = time_stamp_scale().seconds_per_tick;
  const auto begin = Clock::now();
  const std::uint64_t first = time_stamp();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const double stamped = static_cast<double>(time_stamp() - first) * scale;
  const double passed = std::chrono::duration<double>(Clock::now() - begin).count();
  CHECK(stamped <= 1.01 * passed);
  CHECK(stamped >= 0.0198);
  CHECK(time_stamp_scale().cost < 1e-6);
}

TEST_CASE("node costs: every run is a real one") {
  GraphPlan plan = make_random_plan(2, 60, 25, 4);
  GraphPlan expected = plan;
  const StepGraph graph = build_graph(plan);
  const StepGraph expected_graph = build_graph(expected);
  const auto serial = make_executor(expected_graph, ExecutorKind::serial);
  NodeCosts costs(graph);
  for (int run = 0; run < 5; ++run) {
    costs.run();
    serial->run();
  }
  CHECK(costs.runs() == 5);
  CHECK(costs.seconds() > 0.0);
  CHECK(plan.memory == expected.memory);
}

TEST_CASE("node costs: a busy node costs its time, interruptions do not count, idle runs do") {
  using namespace std::chrono_literals;
  int runs = 0;
  StepGraphBuilder builder;
  builder.add_node({"empty"}, {}, {}, []() noexcept {});
  builder.add_node({"interrupted"}, {}, {}, [&runs]() noexcept {
    if (++runs == 5) std::this_thread::sleep_for(20ms);
  });
  builder.add_node({"every other"}, {}, {}, [&runs]() noexcept {
    if (runs % 2 == 0) std::this_thread::sleep_for(2ms);
  });
  builder.add_node({"busy"}, {}, {}, []() noexcept { std::this_thread::sleep_for(1ms); });
  const StepGraph graph = builder.build();
  NodeCosts costs(graph);
  for (int run = 0; run < 12; ++run) costs.run();
  const std::vector<double> seconds = costs.costs();
  CHECK(seconds[0] < 100e-6);
  CHECK(seconds[1] < 100e-6);
  CHECK(seconds[2] > 0.5e-3);  // three of the nine runs that count
  CHECK(seconds[3] >= 1e-3);
}
