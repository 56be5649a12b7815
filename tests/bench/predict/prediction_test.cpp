#include "bench/predict/prediction.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/approx.h"
#include "tests/graph/shapes.h"

using namespace spoke;
using namespace spoke::predict;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr double kNode = 1e-6;  // s
constexpr int kSteps = 20, kBlades = 3, kBodies = 2;

RunGraph run_of(const graph::StepGraph& graph, int window) {
  RunGraph run{.window = window,
               .is_one_pass = window == 1,
               .node_count = graph.node_count(),
               .edge_count = graph.edge_count()};
  run.nodes.serial.costs = equal_costs(graph, kNode);
  run.nodes.serial.runs_per_step = 1.0 / window;
  return run;
}

/// Predicts single steps, and windows for auto, with a handover that takes that long.
Prediction predict_with(double handover, const std::vector<int>& threads = {1, 2, 3}) {
  const graph::StepGraph single = make_window(1, kBlades, kBodies);
  const graph::StepGraph window = make_window(kSteps, kBlades, kBodies);
  Prediction prediction{.scenario = {}};
  prediction.run = run_of(single, 1);
  prediction.auto_run = run_of(window, kSteps);
  prediction.runtime.flow_graph = {2e-9, 0.0, handover};
  predict::predict(prediction, single, &window, threads);
  return prediction;
}

const Series& series_of(ExecutorKind kind, const Prediction& prediction) {
  for (const Series& series : prediction.series)
    if (series.executor == kind) return series;
  throw std::logic_error("not predicted");
}

compare::Measurement measurement_of(ExecutorKind executor, int threads, std::vector<double> times) {
  compare::Measurement measurement;
  measurement.configuration.executor = executor;
  measurement.configuration.threads = threads;
  measurement.step_times = std::move(times);
  return measurement;
}

}  // namespace

TEST_CASE("auto is predicted in its window, the others and one thread of auto step by step") {
  const Prediction prediction = predict_with(0.0);
  const double step = kBlades * (kBodies + 2) * kNode;
  CHECK(prediction.run.work == approx(step));
  CHECK(prediction.run.span == approx(3 * kNode));
  CHECK(prediction.auto_run->work == approx(step));
  CHECK(prediction.auto_run->span == approx(3 * kNode));  // a chain of steps
  CHECK(prediction.serial.step.expected == approx(step));
  for (const Point& point : series_of(ExecutorKind::flow_graph, prediction).points)
    CHECK(point.window == 1);
  const auto& points = series_of(ExecutorKind::automatic, prediction).points;
  REQUIRE(points.size() == 3);
  CHECK(points[0].window == 1);
  CHECK(points[0].step.expected == approx(step));
  CHECK(points[1].window == kSteps);
  CHECK(prediction.speedup(points[1]) > 1.8);
  CHECK(points[2].window == kSteps);
  CHECK(prediction.speedup(points[2]) > 2.7);
}

TEST_CASE("auto leaves a window in which no plan pays") {
  const Prediction prediction = predict_with(1.0);
  for (const Point& point : series_of(ExecutorKind::automatic, prediction).points) {
    CHECK(point.window == 1);
    CHECK(point.step.clusters == 1);
    CHECK(point.step.expected == prediction.serial.step.expected);
  }
}

TEST_CASE("measurements are put beside the points they belong to") {
  Prediction prediction = predict_with(0.0);
  add_measured(prediction, {measurement_of(ExecutorKind::serial, 1, {12e-6, 12e-6, 12e-6}),
                            measurement_of(ExecutorKind::automatic, 2, {6e-6, 8e-6, 6e-6}),
                            measurement_of(ExecutorKind::automatic, 3, {6e-6}),
                            measurement_of(ExecutorKind::automatic, 64, {1e-6, 1e-6})});
  REQUIRE(prediction.serial.measured);
  CHECK(std::abs(*prediction.serial.error()) < 1e-12);
  const auto& points = series_of(ExecutorKind::automatic, prediction).points;
  CHECK_FALSE(points[0].error());
  REQUIRE(points[1].measured);
  CHECK(points[1].measured->step.median == 6e-6);
  CHECK(points[1].measured->speedup.median == approx(2.0));
  CHECK(*points[1].error() == approx(points[1].step.expected / 6e-6 - 1.0));
  CHECK_FALSE(points[2].measured);  // of a single round
}

TEST_CASE("without measured points the band is that between the bounds by work and span") {
  const Prediction prediction = predict_with(0.0);
  const double work = prediction.run.work, span = prediction.run.span;
  for (const Point& point : series_of(ExecutorKind::flow_graph, prediction).points) {
    const double share = work / point.threads;
    CHECK(point.step.optimistic == approx(std::max(share, span)));
    const double greedy = share + (1.0 - 1.0 / point.threads) * span;
    CHECK(point.step.pessimistic == approx(std::max(point.step.expected, greedy)));
  }
}

TEST_CASE("at capacity a bound has less than the number of threads, as far as it was measured") {
  Prediction prediction = predict_with(0.0, {1, 2, 4});
  const Point& two = series_of(ExecutorKind::flow_graph, prediction).points[1];
  const Point& four = series_of(ExecutorKind::flow_graph, prediction).points[2];
  CHECK_FALSE(bound_at_capacity(prediction, ExecutorKind::flow_graph, two));
  prediction.capacity = {2, 1.25, 1.5};
  CHECK(*bound_at_capacity(prediction, ExecutorKind::flow_graph, two) ==
        approx(prediction.run.work / 1.5));
  CHECK_FALSE(bound_at_capacity(prediction, ExecutorKind::flow_graph, four));
}
