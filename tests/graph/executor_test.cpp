#include "graph/executor.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <thread>

#include "spoke/error.h"
#include "tests/graph/arithmetic_graph.h"
#include "tests/graph/recorded_graph.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_random_plan;
using spoke::graph::testing::RecordedGraph;

namespace {

void check_every_run(ExecutorKind kind, int threads) {
  RecordedGraph recorded(make_random_plan(3, 60, 25, 1));
  const auto executor = make_executor(recorded.graph(), kind, threads);
  int faults = 0;
  for (int run = 1; run <= 1000; ++run) {
    executor->run();
    faults += recorded.count_nodes_not_run(run) + recorded.count_edges_out_of_order();
  }
  CHECK(faults == 0);
}

std::vector<std::vector<double>> results(ExecutorKind kind, int threads, int runs) {
  GraphPlan plan = make_random_plan(11, 80, 30, 8);
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, kind, threads);
  for (int run = 0; run < runs; ++run) executor->run();
  return plan.memory;
}

}  // namespace

TEST_CASE("serial: every node runs once per run, after its predecessors") {
  check_every_run(ExecutorKind::serial, 0);
}

TEST_CASE("flow graph: every node runs once per run, after its predecessors") {
  for (const int threads : {1, 2, 3, 6, 12}) {
    CAPTURE(threads);
    check_every_run(ExecutorKind::flow_graph, threads);
  }
}

// The values are finite, so that equal vectors are equal bits but for the sign of zero.
TEST_CASE("flow graph: results equal the serial ones, whatever the number of threads") {
  const auto serial = results(ExecutorKind::serial, 0, 200);
  for (const int threads : {1, 2, 3, 6, 12}) {
    CAPTURE(threads);
    CHECK(results(ExecutorKind::flow_graph, threads, 200) == serial);
  }
}

TEST_CASE("flow graph: the threads asked for exist, beyond the number of processors") {
  constexpr int threads = 6;
  std::atomic<int> arrived{0};
  StepGraphBuilder builder;
  for (int i = 0; i < threads; ++i) {
    // No node ends before all have begun: with fewer threads this would not return.
    builder.add_node({"meet", i}, reads(), writes(), [&arrived]() noexcept {
      ++arrived;
      while (arrived < threads) std::this_thread::yield();
    });
  }
  const StepGraph graph = builder.build();
  // An executor of fewer threads at the same time must not lower the limit.
  const StepGraph other = builder.build();
  const auto smaller = make_executor(other, ExecutorKind::flow_graph, 3);
  const auto executor = make_executor(graph, ExecutorKind::flow_graph, threads);
  executor->run();
  CHECK(arrived == threads);
}

TEST_CASE("an empty graph runs") {
  const StepGraph graph = StepGraphBuilder().build();
  make_executor(graph, ExecutorKind::serial)->run();
  make_executor(graph, ExecutorKind::flow_graph, 2)->run();
}

TEST_CASE("two executors run at once in two threads of the program") {
  const auto serial = results(ExecutorKind::serial, 0, 300);
  std::vector<std::vector<double>> first;
  std::vector<std::vector<double>> second;
  std::thread one([&] { first = results(ExecutorKind::flow_graph, 2, 300); });
  std::thread two([&] { second = results(ExecutorKind::flow_graph, 3, 300); });
  one.join();
  two.join();
  CHECK(first == serial);
  CHECK(second == serial);
}

TEST_CASE("an executor made in one thread may run in another") {
  RecordedGraph recorded(make_random_plan(3, 60, 25, 1));
  const auto executor = make_executor(recorded.graph(), ExecutorKind::flow_graph, 2);
  std::thread([&] { executor->run(); }).join();
  executor->run();
  CHECK(recorded.count_nodes_not_run(2) == 0);
  CHECK(recorded.count_edges_out_of_order() == 0);
}

TEST_CASE("executors tell their name and threads, and refuse a negative number") {
  const StepGraph graph = StepGraphBuilder().build();
  CHECK(make_executor(graph, ExecutorKind::serial, 5)->threads() == Threads(1));
  CHECK(make_executor(graph, ExecutorKind::serial)->name() == "serial");
  CHECK(make_executor(graph, ExecutorKind::flow_graph, 3)->threads() == Threads(3));
  CHECK(make_executor(graph, ExecutorKind::flow_graph)->threads() == Threads(available_threads()));
  CHECK(make_executor(graph, ExecutorKind::flow_graph)->name() == "flow_graph");
  CHECK_THROWS_AS(make_executor(graph, ExecutorKind::flow_graph, -1), spoke::InputError);
}

TEST_CASE("kinds are found by name, and one that this build is without is refused, and why") {
  const StepGraph graph = StepGraphBuilder().build();
  const auto kinds = executor_kinds();
  for (const ExecutorKind kind : kinds) CHECK(executor_kind(name_of(kind)) == kind);
  CHECK_THROWS_WITH_AS(
      executor_kind("openmp"),
      doctest::Contains("no executor is named \"openmp\"; known here: auto, flow_graph"),
      spoke::InputError);
  for (const ExecutorKind kind : {ExecutorKind::openmp_scheme1, ExecutorKind::openmp_scheme2,
                                  ExecutorKind::openmp_levels, ExecutorKind::openmp_tasks}) {
    if (has_executor(kind)) continue;
    const std::string why = std::string(name_of(kind)) +
                            " needs OpenMP, which this build is without (SPOKE_OPENMP=OFF); known "
                            "here: auto, flow_graph, serial";
    CHECK_THROWS_WITH_AS(executor_kind(name_of(kind)), why.c_str(), spoke::InputError);
    CHECK_THROWS_WITH_AS(make_executor(graph, kind), why.c_str(), spoke::InputError);
  }
}

TEST_CASE("executors of one layer of threads refuse nested teams") {
  const StepGraph graph = StepGraphBuilder().build();
  CHECK_THROWS_AS(make_executor(graph, ExecutorKind::flow_graph, {3, 2}), spoke::InputError);
  CHECK_THROWS_AS(make_executor(graph, ExecutorKind::serial, {1, 0}), spoke::InputError);
}

TEST_CASE("executors refuse more threads than any has use for, one by one or in teams") {
  const StepGraph graph = StepGraphBuilder().build();
  for (const ExecutorKind kind : executor_kinds()) {
    CAPTURE(name_of(kind));
    CHECK_NOTHROW(check_threads(kind, kMostThreads));
    CHECK_THROWS_WITH_AS(make_executor(graph, kind, 100000),
                         "number of threads: expected at most 1024 in all, got 100000",
                         spoke::InputError);
    for (const Threads threads : {Threads(33, 32), Threads(0, 1025), Threads(1 << 30, 1 << 30)})
      CHECK_THROWS_WITH_AS(check_threads(kind, threads), doctest::Contains("at most 1024 in all"),
                           spoke::InputError);
  }
}

TEST_CASE("the available threads are at least one and at most the processors") {
  CHECK(available_threads() >= 1);
  // hardware_concurrency() would be 1 for a thread that OpenMP has bound.
  CHECK(available_threads() <= sysconf(_SC_NPROCESSORS_ONLN));
}

TEST_CASE("a flow graph's threads round as the thread that made it, whoever had its arena before") {
  StepGraphBuilder builder;
  std::vector<int> modes(12, -1);
  for (int i = 0; i < 12; ++i)
    builder.add_node(
        {"round", i}, reads(), writes(),
        [&mode = modes[static_cast<std::size_t>(i)]]() noexcept { mode = std::fegetround(); });
  const StepGraph graph = builder.build();
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_TONEAREST}) {
    std::fesetround(mode);
    const auto executor = make_executor(graph, ExecutorKind::flow_graph, 2);
    for (int run = 0; run < 20; ++run) {
      executor->run();
      CHECK(modes == std::vector<int>(12, mode));
    }
  }
}
