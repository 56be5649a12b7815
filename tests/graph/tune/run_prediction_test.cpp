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
constexpr Overheads kNone{0.0, 0.0, 0.0}, kCostly{2e-9, 200e-9, 1e-6};

}  // namespace

TEST_CASE("prediction: without overheads a fan takes what work and span say") {
  const StepGraph graph = make_fan(4, 3);
  const RunPredictor predictor(graph, equal_costs(graph, kNode));
  CHECK(predictor.work() == approx(14 * kNode));
  CHECK(predictor.span() == approx(5 * kNode));
  CHECK(predictor.schedule(1, kNone) == approx(14 * kNode));
  CHECK(predictor.schedule(2, kNone) == approx(8 * kNode));
  CHECK(predictor.schedule(4, kNone) == approx(5 * kNode));
  CHECK(predictor.schedule(64, kNone) == approx(5 * kNode));
}

TEST_CASE("prediction: schedules lie between the bounds by work and span") {
  const StepGraph fan = make_fan(5, 3), window = make_window(2, 5, 3);
  for (const StepGraph* graph : {&fan, &window}) {
    for (const auto& costs : {equal_costs(*graph, kNode), random_costs(3, *graph)}) {
      const RunPredictor predictor(*graph, costs);
      const double work = predictor.work(), span = predictor.span();
      for (const int processors : {1, 2, 3, 4, 8}) {
        CAPTURE(processors);
        const double least = (1.0 - 1e-12) * std::max(work / processors, span);
        // No greedy schedule is beyond Graham's bound if tasks cost nothing.
        const double most = (1.0 + 1e-12) * (work / processors + (1.0 - 1.0 / processors) * span);
        CHECK(predictor.schedule(processors, kNone) >= least);
        CHECK(predictor.schedule(processors, kNone) <= most);
        CHECK(predictor.schedule(processors, kCostly) > predictor.schedule(processors, kNone));
        CHECK(predictor.choose(processors).seconds >= least);
      }
    }
  }
}

TEST_CASE("prediction: auto is never slower than serial") {
  const StepGraph graph = make_fan(8, 4);
  const RunPredictor tiny(graph, equal_costs(graph, 10e-9));
  for (const int threads : {1, 2, 8}) {
    const AutoRun run = tiny.choose(threads);
    CHECK(run.seconds == approx(tiny.work()));
    CHECK(run.clusters == 1);
    CHECK(tiny.schedule(threads, kCostly) > run.seconds);
  }
  const RunPredictor large(graph, equal_costs(graph, kNode));
  CHECK(large.choose(1).seconds == approx(large.work()));
  const AutoRun chosen = large.choose(8);
  CHECK(chosen.clusters > 1);
  // At best 6 of 34 nodes, one after the other; processors have to find them.
  CHECK(chosen.seconds < 0.3 * large.work());
}
