#include "graph/tune/run_prediction.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/approx.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr double kNode = 10e-6;  // s

RuntimeCosts costly() {
  RuntimeCosts runtime;
  runtime.flow_graph = {2e-9, 200e-9, 1e-6};
  runtime.barrier = 1e-6;
  runtime.barrier_alone = 0.1e-6;
  return runtime;
}

RunPredictor predictor_of(const StepGraph& graph, const RuntimeCosts& runtime,
                          CostSpread spread = {}) {
  return {graph, equal_costs(graph, kNode), runtime, spread};
}

}  // namespace

TEST_CASE("prediction: without overheads a fan takes what work and span say") {
  const StepGraph graph = make_fan(4, 3);
  RuntimeCosts runtime;
  runtime.flow_graph = {0.0, 0.0, 0.0};
  const RunPredictor predictor = predictor_of(graph, runtime);
  CHECK(predictor.work() == approx(14 * kNode));
  CHECK(predictor.span() == approx(5 * kNode));
  for (const ExecutorKind kind : {ExecutorKind::flow_graph, ExecutorKind::automatic}) {
    CHECK(predictor.predict(kind, 1).expected == approx(14 * kNode));
    CHECK(predictor.predict(kind, 2).expected == approx(8 * kNode));
    CHECK(predictor.predict(kind, 4).expected == approx(5 * kNode));
    CHECK(predictor.predict(kind, 64).expected == approx(5 * kNode));
  }
  CHECK(predictor.predict(ExecutorKind::serial, 1).expected == approx(14 * kNode));
  CHECK_FALSE(predictor.can_predict(ExecutorKind::openmp_levels));  // no barrier was measured
  CHECK_FALSE(predictor.can_predict(ExecutorKind::openmp_scheme1));
  CHECK_FALSE(predictor.can_predict(ExecutorKind::openmp_tasks));
}

TEST_CASE("prediction: levels take their costliest share and their barriers") {
  const StepGraph graph = make_fan(3, 1);
  const RunPredictor predictor = predictor_of(graph, costly());
  REQUIRE(predictor.can_predict(ExecutorKind::openmp_levels));
  const auto seconds = [&](int threads) {
    return predictor.predict(ExecutorKind::openmp_levels, threads).expected;
  };
  CHECK(seconds(1) == approx(5 * kNode + 2 * 0.1e-6));
  // Root, two of three nodes, join: a barrier between any two, and one before the next run.
  CHECK(seconds(2) == approx(4 * kNode + 3 * 1e-6));
  CHECK(seconds(4) == approx(3 * kNode + 3 * 2e-6));
}

TEST_CASE("prediction: every executor lies between the bounds by work and span") {
  const StepGraph graph = make_window(2, 5, 3);
  const RunPredictor exact = predictor_of(graph, costly());
  const RunPredictor spread = predictor_of(graph, costly(), {0.9, 1.2});
  const double work = exact.work(), span = exact.span();
  for (const ExecutorKind kind : {ExecutorKind::serial, ExecutorKind::flow_graph,
                                  ExecutorKind::automatic, ExecutorKind::openmp_levels}) {
    for (const int threads : {1, 2, 3, 8}) {
      if (kind == ExecutorKind::serial && threads > 1) continue;
      CAPTURE(name_of(kind));
      CAPTURE(threads);
      const PredictedRun run = exact.predict(kind, threads);
      CHECK(run.optimistic == approx(std::max(work / threads, span)));
      CHECK(run.pessimistic >= approx((work - span) / threads + span));
      CHECK(run.optimistic <= run.expected);
      CHECK(run.expected <= run.pessimistic);
      const PredictedRun wide = spread.predict(kind, threads);
      CHECK(wide.expected == approx(run.expected));
      CHECK(wide.optimistic == approx(0.9 * run.optimistic));
      CHECK(wide.pessimistic >= run.pessimistic);
    }
  }
}

TEST_CASE("prediction: without overheads no greedy schedule is beyond Graham's bound") {
  RuntimeCosts runtime;
  runtime.flow_graph = {0.0, 0.0, 0.0};
  const StepGraph fan = make_fan(5, 3), window = make_window(2, 5, 3);
  for (const StepGraph* graph : {&fan, &window}) {
    const RunPredictor predictor = predictor_of(*graph, runtime);
    for (const int threads : {1, 2, 3, 4, 8}) {
      CAPTURE(threads);
      const double share = predictor.work() / threads, span = predictor.span();
      const double seconds = predictor.predict(ExecutorKind::flow_graph, threads).expected;
      CHECK(seconds >= (1.0 - 1e-12) * std::max(share, span));
      CHECK(seconds <= (1.0 + 1e-12) * (share + (1.0 - 1.0 / threads) * span));
    }
  }
}

TEST_CASE("prediction: auto is never slower than serial") {
  const StepGraph graph = make_fan(8, 4);
  const RunPredictor tiny(graph, equal_costs(graph, 10e-9), costly());
  for (const int threads : {1, 2, 8}) {
    const PredictedRun run = tiny.predict(ExecutorKind::automatic, threads);
    CHECK(run.expected == approx(tiny.work()));
    CHECK(run.clusters == 1);
    CHECK(tiny.predict(ExecutorKind::flow_graph, threads).expected > run.expected);
  }
  const RunPredictor large = predictor_of(graph, costly());
  // At best 6 of 34 nodes, one after the other; processors have to find them.
  CHECK(large.predict(ExecutorKind::automatic, 8).expected < 0.3 * large.work());
}

TEST_CASE("runtime costs are positive") {
  const RuntimeCosts costs = measure_runtime_costs();
  CHECK(costs.flow_graph.per_cluster > 0.0);
  CHECK(costs.flow_graph.handover > 0.0);
  CHECK((costs.barrier > 0.0) == has_executor(ExecutorKind::openmp_levels));
}
