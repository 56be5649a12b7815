#include "graph/run_trace.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_step_plan;

namespace {

/// Returns what is wrong with a trace, in words; empty if nothing is.
std::string find_fault(const RunTrace& trace, const StepGraph& graph, int threads) {
  std::vector<const NodeRun*> of_node(static_cast<std::size_t>(graph.node_count()));
  for (const NodeRun& run : trace.nodes) {
    const NodeRun*& own = of_node[static_cast<std::size_t>(run.node.index)];
    if (own) return "a node is there twice";
    own = &run;
    if (run.thread < 0 || run.thread >= threads) return "there is no such thread";
    if (run.begin < 0.0 || run.end < run.begin || run.end > trace.duration) return "a wrong time";
  }
  for (int i = 0; i < graph.node_count(); ++i) {
    const NodeRun* run = of_node[static_cast<std::size_t>(i)];
    if (!run) return "a node is missing";
    for (const NodeId before : graph.predecessors({i}))
      if (of_node[static_cast<std::size_t>(before.index)]->end > run->begin)
        return "a node begins before its predecessor has ended";
  }
  return {};
}

}  // namespace

TEST_CASE("a traced run has each node once, by begin, in the order of the edges") {
  for (const ExecutorKind kind : executor_kinds())
    for (const int threads : {1, 2}) {
      CAPTURE(name_of(kind));
      CAPTURE(threads);
      GraphPlan plan = make_step_plan({3, 4, 2, true});
      const StepGraph graph = build_graph(plan);
      const auto executor = make_executor(graph, kind, threads);
      for (int run = 0; run < 20; ++run) {
        const RunTrace trace = trace_run(graph, *executor);
        CHECK(find_fault(trace, graph, executor->threads().total()) == "");
        CHECK(std::is_sorted(trace.nodes.begin(), trace.nodes.end(),
                             [](const NodeRun& a, const NodeRun& b) { return a.begin < b.begin; }));
      }
    }
}

TEST_CASE("a traced run leaves what an ordinary one leaves") {
  for (const ExecutorKind kind : executor_kinds()) {
    CAPTURE(name_of(kind));
    GraphPlan traced = make_step_plan({3, 4, 2, true}), plain = traced;
    const StepGraph traced_graph = build_graph(traced), plain_graph = build_graph(plain);
    const auto executor = make_executor(traced_graph, kind, 2);
    trace_run(traced_graph, *executor);
    executor->run();
    const auto serial = make_executor(plain_graph, ExecutorKind::serial);
    serial->run();
    serial->run();
    CHECK(traced.memory == plain.memory);
  }
}

TEST_CASE("a traced run of an empty graph is empty") {
  StepGraphBuilder builder;
  const StepGraph graph = builder.build();
  for (const ExecutorKind kind : executor_kinds()) {
    CAPTURE(name_of(kind));
    const auto executor = make_executor(graph, kind, 2);
    CHECK(trace_run(graph, *executor).nodes.empty());
  }
}
