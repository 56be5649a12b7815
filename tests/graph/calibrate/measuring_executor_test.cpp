#include "graph/calibrate/measuring_executor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>

#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

TEST_CASE("measuring executor: runs as the serial one does, and counts") {
  GraphPlan plan = make_random_plan(3, 40, 20, 4);
  GraphPlan expected = plan;
  const StepGraph graph = build_graph(plan);
  const StepGraph expected_graph = build_graph(expected);
  const auto serial = make_executor(expected_graph, ExecutorKind::serial);
  MeasuringExecutor executor(graph);
  CHECK(executor.between_runs() == 0.0);
  int left = 6;
  executor.run_while([&left] { return --left > 0; });
  executor.run();
  for (int run = 0; run < 7; ++run) serial->run();
  CHECK(plan.memory == expected.memory);
  CHECK(executor.runs() == 7);
  CHECK(executor.run_times().size() == 3);  // stamps are in the runs 0, 3, 5, 6
  CHECK(executor.node_costs().size() == 40);
  CHECK(executor.name() == "serial");
  CHECK(executor.threads() == 1);
}

TEST_CASE("measuring executor: what is done between runs is not the nodes' cost") {
  using namespace std::chrono_literals;
  StepGraphBuilder builder;
  builder.add_node({"busy"}, {}, {}, []() noexcept { std::this_thread::sleep_for(1ms); });
  const StepGraph graph = builder.build();
  MeasuringExecutor executor(graph);
  int left = 5;
  executor.run_while([&left] {
    std::this_thread::sleep_for(20ms);  // a busy machine makes much more of 1 ms
    return --left > 0;
  });
  CHECK(executor.between_runs() >= 20e-3);
  for (const double time : executor.run_times()) CHECK(time >= 1e-3);
  CHECK(executor.node_costs()[0] >= 1e-3);
  CHECK(executor.node_costs()[0] < 20e-3);
}

TEST_CASE("measuring executor: dear runs count, an interruption does not") {
  using namespace std::chrono_literals;
  int runs = 0;
  StepGraphBuilder builder;
  builder.add_node({"now and then"}, {}, {}, [&runs]() noexcept {
    std::this_thread::sleep_for(runs % 8 == 0 ? 8ms : runs == 61 ? 300ms : 0ms);
    ++runs;
  });
  const StepGraph graph = builder.build();
  MeasuringExecutor executor(graph);
  for (int run = 0; run < 160; ++run) executor.run();
  CHECK(executor.node_costs()[0] > 0.5e-3);  // 1 ms on average
  CHECK(executor.node_costs()[0] < 3e-3);    // 5 ms with the interruption
}

TEST_CASE("measuring executor: nodes cost in sum what they cost without stamps") {
  GraphPlan plan = make_random_plan(4, 60, 30, 4);
  const StepGraph graph = build_graph(plan);
  MeasuringExecutor executor(graph);
  for (int run = 0; run < 400; ++run) executor.run();
  const std::vector<double> costs = executor.node_costs();
  const double sum = std::accumulate(costs.begin(), costs.end(), 0.0);
  std::vector<double> times = executor.run_times();
  std::sort(times.begin(), times.end());
  CHECK(sum >= times.front());
  CHECK(sum <= times.back());
  for (const double cost : costs) CHECK(cost >= 0.0);
}
