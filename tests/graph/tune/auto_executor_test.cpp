#include "graph/tune/auto_executor.h"

#include <doctest/doctest.h>

#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "graph/executor.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;

namespace {

// Runs until the executor has settled. Returns the number of runs, or `limit`.
int settle(Executor& executor, int limit = 200000) {
  int runs = 0;
  while (executor.tuning() && runs < limit) {
    executor.run();
    ++runs;
  }
  return runs;
}

// Makes a plan of which two side by side are worth a thread.
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

TEST_CASE("auto: with known costs it goes parallel at once, unless threads are worth nothing") {
  GraphPlan plan = costly_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_auto_executor(graph, 2, {equal_costs(graph, 5e-6), 100.0});
  CHECK_FALSE(executor->tuning());
  CHECK(executor->choices() == 1);
  if (available_threads() == 1) return;
  const bool is_parallel = executor->recorded_threads() == 2;
  CHECK(is_parallel == (executor->describe().find("clusters of") != std::string::npos));
  CHECK((is_parallel || executor->describe().find("times the work of one") != std::string::npos));
}

TEST_CASE("auto: a plan that is slower than serial runs is left, and tried again later") {
  std::mutex obstacle;
  bool is_disturbed = true;
  StepGraphBuilder builder;
  for (int k = 0; k < 2; ++k)
    builder.add_node({"asleep", k}, {}, {}, [&]() noexcept {
      std::unique_lock lock(obstacle, std::defer_lock);
      if (is_disturbed) lock.lock();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  const StepGraph graph = builder.build();
  // These nodes take longer than estimated, since they sleep on one thread, too; the serial runs
  // that follow show it.
  const auto executor = make_auto_executor(graph, 2, {equal_costs(graph, 0.2e-3), 100.0, true});
  if (available_threads() == 1) return;
  const auto is_serial = [&] { return executor->describe().rfind("serial: ", 0) == 0; };
  REQUIRE_FALSE(is_serial());
  for (int run = 0; run < 10 && !is_serial(); ++run) executor->run();
  REQUIRE(is_serial());
  const std::string left = executor->describe();
  is_disturbed = false;
  // Where other programs have the processors, it measures what threads are worth, says so, and
  // stays serial.
  int runs = 0;
  for (; runs < 2000 && executor->describe() == left; ++runs) executor->run();
  CHECK(runs < 2000);
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
