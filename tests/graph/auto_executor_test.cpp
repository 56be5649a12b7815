#include <doctest/doctest.h>

#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "graph/executor.h"
#include "graph/plan_choice.h"
#include "tests/approx.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

// Runs until the executor has settled; the number of runs, or `limit`.
int settle(Executor& executor, int limit = 200000) {
  int runs = 0;
  while (executor.tuning() && runs < limit) {
    executor.run();
    ++runs;
  }
  return runs;
}

// Two of them side by side are worth a thread.
GraphPlan costly_plan() { return make_random_plan(11, 300, 120, 60); }

}  // namespace

TEST_CASE("auto: results equal the serial ones at every stage of tuning") {
  GraphPlan plan = costly_plan();
  GraphPlan serial_memory = costly_plan();
  const StepGraph graph = build_graph(plan);
  const StepGraph serial_graph = build_graph(serial_memory);
  const auto serial = make_executor(serial_graph, ExecutorKind::serial);
  for (const int threads : {1, 2, 3, 6, 12}) {
    CAPTURE(threads);
    const auto executor = make_executor(graph, ExecutorKind::automatic, threads);
    CHECK(executor->threads() == Threads(threads));
    CHECK(executor->name() == "auto");
    reset_memory(plan);
    reset_memory(serial_memory);
    int differing = 0;
    int after = 0;
    for (int run = 0; run < 10000 && after < 10; ++run) {
      if (!executor->tuning()) ++after;
      executor->run();
      serial->run();
      differing += plan.memory == serial_memory.memory ? 0 : 1;
    }
    CHECK(differing == 0);
    CHECK(after == 10);
  }
}

TEST_CASE("auto: empty nodes are run serially") {
  const StepGraph graph = make_fan(24, 10);
  const auto executor = make_executor(graph, ExecutorKind::automatic, 2);
  CHECK(executor->recorded_threads() == 1);  // before it has chosen
  settle(*executor);
  CHECK_FALSE(executor->tuning());
  CHECK(executor->describe().rfind("serial: ", 0) == 0);
  CHECK(executor->threads() == 2);
  CHECK(executor->recorded_threads() == 1);
}

TEST_CASE("auto: one thread is serial at once") {
  const StepGraph graph = make_fan(4, 3);
  const auto executor = make_executor(graph, ExecutorKind::automatic, 1);
  CHECK_FALSE(executor->tuning());
  CHECK(executor->choices() == 1);
  CHECK(executor->describe() == "serial: one thread");
}

TEST_CASE("auto: a gain that was foreseen and not found is looked for again") {
  std::mutex obstacle;
  bool is_disturbed = true;
  StepGraphBuilder builder;
  for (int k = 0; k < 2; ++k)
    builder.add_node({"asleep"}, {}, writes(builder.add_part("part", {})), [&]() noexcept {
      std::unique_lock lock(obstacle, std::defer_lock);
      if (is_disturbed) lock.lock();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  const StepGraph graph = builder.build();
  const auto executor = make_executor(graph, ExecutorKind::automatic, 2);
  CHECK(executor->choices() == 0);
  const int runs = settle(*executor);
  CHECK(executor->choices() == 1);
  if (available_threads() == 1) return;
  CHECK(executor->describe().rfind("serial: ", 0) == 0);
  is_disturbed = false;
  for (int run = 0; run <= 3 * runs && !executor->tuning(); ++run) executor->run();
  REQUIRE(executor->tuning());
  settle(*executor);
  // Which plan it then chooses depends on what else the machine does.
  CHECK(executor->choices() == 2);
}

TEST_CASE("auto: an empty graph runs") {
  const StepGraph graph = StepGraphBuilder().build();
  const auto executor = make_executor(graph, ExecutorKind::automatic, 2);
  CHECK(settle(*executor) == 0);
  executor->run();
}

TEST_CASE("executors describe themselves") {
  const StepGraph graph = make_fan(2, 1);
  CHECK(make_executor(graph, ExecutorKind::serial)->describe() == "serial on 1 thread");
  // Two nodes find work for two threads.
  CHECK(make_executor(graph, ExecutorKind::flow_graph, 2)->describe() == "flow_graph on 2 threads");
  CHECK(make_executor(graph, ExecutorKind::flow_graph, 3)->describe() ==
        "flow_graph on 3 threads, 2 at work");
}

TEST_CASE("choice: the largest median of ratios wins, if the gain is 5 %") {
  const std::vector<Samples> samples{{10, 10, 10}, {9, 9, 9}, {6, 5, 5}};
  const std::vector<double> foreseen{1.0, 1.5, 1.9};
  const Choice choice = choose_plan(samples, foreseen);
  CHECK(choice.index == 2);
  CHECK(choice.speedup == approx(2.0));
  CHECK(choice.foreseen == 1.9);
}

TEST_CASE("choice: what nobody has foreseen counts for little more than that") {
  const std::vector<Samples> samples{{10, 10, 10}, {5, 5, 5}, {6, 6, 6}};
  const Choice choice = choose_plan(samples, std::vector<double>{1.0, 1.4, 1.7});
  CHECK(choice.index == 2);  // 1.67 as found, not 1.61 for the other
  CHECK(choose_plan(samples, std::vector<double>{1.0, 1.5, 1.7}).index == 1);  // 1.725
}

TEST_CASE("choice: serial wins against small gains, and alone") {
  const Choice small = choose_plan(std::vector<Samples>{{10, 10, 10}, {9.6, 9.6, 9.6}},
                                   std::vector<double>{1.0, 1.0});
  CHECK(small.index == 0);
  CHECK(small.speedup == approx(10 / 9.6));
  CHECK(choose_plan(std::vector<Samples>{{10, 10, 10}}, std::vector<double>{1.0}).index == 0);
}

TEST_CASE("choice: a disturbance that meets whole rounds cancels, a single one does not count") {
  const std::vector<double> foreseen{1.0, 1.2};
  const std::vector<Samples> rounds{{10, 50, 11, 10, 10}, {8, 40, 9, 8, 8}};
  CHECK(choose_plan(rounds, foreseen).speedup == approx(1.25));
  const std::vector<Samples> single{{10, 10, 500, 10, 10}, {10, 10, 10, 10, 10}};
  CHECK(choose_plan(single, foreseen).index == 0);
}
