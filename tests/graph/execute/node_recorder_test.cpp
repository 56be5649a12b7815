#include "graph/execute/node_recorder.h"

#include <doctest/doctest.h>

#include <vector>

#include "graph/executor.h"
#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_step_plan;

namespace {

constexpr std::size_t kPlenty = std::size_t{1} << 24;  // bytes

GraphPlan step_plan() { return make_step_plan({3, 4, 2, true}); }

NodeRecorder make_recorder(const Executor& executor, const StepGraph& graph, std::size_t runs) {
  const int threads = executor.threads().total();
  return NodeRecorder(threads, graph.node_count(),
                      make_room(runs, graph.node_count(), threads, kPlenty));
}

void run_recorded(Executor& executor, NodeRecorder& recorder, int runs) {
  executor.set_recorder(&recorder);
  int left = runs;
  recorder.begin_run();
  executor.run_while([&] {
    recorder.end_run();
    if (--left == 0) return false;
    recorder.begin_run();
    return true;
  });
  executor.set_recorder(nullptr);
}

/// Returns what is wrong with the records of a run, in words; empty if nothing is.
std::string find_fault(const NodeRecorder& recorder, int run, const StepGraph& graph) {
  std::vector<NodeRecord> of_node(static_cast<std::size_t>(graph.node_count()));
  for (int thread = 0; thread < recorder.threads(); ++thread) {
    std::uint64_t before = recorder.run(run).begin;
    for (const NodeRecord& record : recorder.records(run, thread)) {
      if (record.begin < before) return "nodes overlap on a thread, or begin before the run";
      if (record.end < record.begin) return "a node ends before it begins";
      before = record.end;
      NodeRecord& own = of_node[static_cast<std::size_t>(record.node)];
      if (own.node >= 0) return "a node is there twice";
      own = record;
    }
    if (before > recorder.run(run).end) return "a node ends after the run";
  }
  for (int i = 0; i < graph.node_count(); ++i) {
    const NodeRecord& record = of_node[static_cast<std::size_t>(i)];
    if (record.node != i) return "a node is missing";
    for (const NodeId before : graph.predecessors({i}))
      if (of_node[static_cast<std::size_t>(before.index)].end > record.begin)
        return "a node begins before its predecessor has ended";
  }
  return {};
}

void check_records(ExecutorKind kind, Threads threads) {
  constexpr int runs = 40;
  GraphPlan plan = step_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, kind, threads);
  executor->run();
  NodeRecorder recorder = make_recorder(*executor, graph, runs);
  run_recorded(*executor, recorder, runs);
  executor->run();  // unrecorded
  REQUIRE(recorder.runs() == runs);
  CHECK(recorder.dropped_runs() == 0);
  for (int run = 0; run < runs; ++run) {
    CHECK(find_fault(recorder, run, graph) == "");
    if (run > 0) CHECK(recorder.run(run - 1).end <= recorder.run(run).begin);
  }
}

std::vector<std::vector<double>> results(ExecutorKind kind, bool is_recorded) {
  constexpr int runs = 50;
  GraphPlan plan = step_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, kind, 2);
  NodeRecorder recorder = make_recorder(*executor, graph, runs);
  if (is_recorded)
    run_recorded(*executor, recorder, runs);
  else
    for (int run = 0; run < runs; ++run) executor->run();
  return plan.memory;
}

}  // namespace

TEST_CASE("every executor records each node once per run, in the order of the edges") {
  for (const ExecutorKind kind : executor_kinds())
    for (const int threads : {1, 2, 3, 6}) {
      CAPTURE(name_of(kind));
      CAPTURE(threads);
      check_records(kind, threads);
    }
}

TEST_CASE("nested teams record each node once per run") {
  for (const ExecutorKind kind : executor_kinds()) {
    if (kind != ExecutorKind::openmp_scheme1 && kind != ExecutorKind::openmp_scheme2) continue;
    for (const Threads threads : {Threads{1, 2}, {2, 2}, {3, 4}}) {
      CAPTURE(name_of(kind));
      CAPTURE(name_of(threads));
      check_records(kind, threads);
    }
  }
}

TEST_CASE("recording leaves the results alone") {
  for (const ExecutorKind kind : executor_kinds()) {
    CAPTURE(name_of(kind));
    CHECK(results(kind, true) == results(kind, false));
  }
}

TEST_CASE("what runs on one thread is all recorded there, without a pause between nodes") {
  GraphPlan plan = step_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, ExecutorKind::serial);
  NodeRecorder recorder = make_recorder(*executor, graph, 1);
  run_recorded(*executor, recorder, 1);
  const auto records = recorder.records(0, 0);
  REQUIRE(records.size() == static_cast<std::size_t>(graph.node_count()));
  for (std::size_t k = 0; k < records.size(); ++k) {
    CHECK(records[k].node == graph.serial_order()[k].index);
    CHECK(records[k].cluster == -1);
    if (k > 0) CHECK(records[k].begin == records[k - 1].end);
  }
}

TEST_CASE("the flow graph of single nodes records a cluster for each node") {
  GraphPlan plan = step_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, ExecutorKind::flow_graph, 2);
  NodeRecorder recorder = make_recorder(*executor, graph, 1);
  run_recorded(*executor, recorder, 1);
  for (int thread = 0; thread < 2; ++thread)
    for (const NodeRecord& record : recorder.records(0, thread))
      CHECK(graph.serial_order()[static_cast<std::size_t>(record.cluster)].index == record.node);
}

TEST_CASE("runs without room are dropped as a whole and counted") {
  GraphPlan plan = step_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, ExecutorKind::serial);
  const auto nodes = static_cast<std::size_t>(graph.node_count());
  for (const RecorderRoom room : {RecorderRoom{10, 3 * nodes + 5}, {3, 100 * nodes}}) {
    NodeRecorder recorder(1, graph.node_count(), room);
    run_recorded(*executor, recorder, 7);
    CHECK(recorder.runs() == 3);
    CHECK(recorder.dropped_runs() == 4);
    for (int run = 0; run < 3; ++run) CHECK(find_fault(recorder, run, graph) == "");
    recorder.clear();
    CHECK(recorder.runs() == 0);
    CHECK(recorder.dropped_runs() == 0);
    run_recorded(*executor, recorder, 2);
    CHECK(recorder.runs() == 2);
  }
}

TEST_CASE("room is made for all nodes on any thread, within the memory allowed") {
  CHECK(make_room(5, 10, 3, kPlenty).records_per_thread == 50);
  CHECK(make_room(5, 10, 3, kPlenty).runs == 5);
  CHECK(make_room(5, 10, 2, 40 * sizeof(NodeRecord)).records_per_thread == 20);
}

TEST_CASE("auto records serial runs until it has chosen, and does not choose meanwhile") {
  GraphPlan plan = step_plan();
  const StepGraph graph = build_graph(plan);
  const auto executor = make_executor(graph, ExecutorKind::automatic, 2);
  const bool was_tuning = executor->tuning();  // unless there is only one processor
  NodeRecorder recorder = make_recorder(*executor, graph, 100);
  run_recorded(*executor, recorder, 100);
  CHECK(executor->tuning() == was_tuning);
  if (was_tuning) CHECK(recorder.records(99, 0).size() == recorder.records(0, 0).size());
}
