// Predicts each executor on each number of threads, and adds the measured points.

#include "bench/predict/prediction.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "bench/compare/statistics.h"

namespace spoke::predict {
namespace {

/// Converts the times of a run to those of a step.
graph::PredictedRun per_step(graph::PredictedRun run, const NodeMeasurement& nodes) {
  for (double* seconds : {&run.expected, &run.optimistic, &run.pessimistic})
    *seconds = nodes.runs_per_step * (*seconds + nodes.between_runs);
  return run;
}

/// Predicts steps that are made by runs of one graph.
class StepPredictor {
 public:
  StepPredictor(RunGraph& run, const graph::StepGraph& graph, const graph::RuntimeCosts& runtime)
      : run_(run), predictor_(graph, run.nodes.serial.costs, runtime, run.nodes.spread) {
    run.work = run.nodes.serial.runs_per_step * predictor_.work();
    run.span = run.nodes.serial.runs_per_step * predictor_.span();
  }

  bool can_predict(ExecutorKind kind) const { return predictor_.can_predict(kind); }
  Point predict(ExecutorKind kind, int threads) const {
    return {threads, run_.window, per_step(predictor_.predict(kind, threads), run_.nodes.serial)};
  }

 private:
  const RunGraph& run_;
  graph::RunPredictor predictor_;
};

/// Whether auto runs all nodes of the graph on one thread; it then drops a window that it chose.
bool is_serial(const Point& point) { return point.step.clusters == 1; }

bool is_predictable(ExecutorKind kind) {
  return kind == ExecutorKind::flow_graph || kind == ExecutorKind::automatic ||
         kind == ExecutorKind::openmp_levels;
}

Point* find_point(Prediction& prediction, const compare::Configuration& configuration) {
  if (configuration.executor == ExecutorKind::serial) return &prediction.serial;
  for (Series& series : prediction.series)
    for (Point& point : series.points)
      if (series.executor == configuration.executor && configuration.threads == point.threads)
        return &point;
  return nullptr;
}

}  // namespace

std::string describe_runs(const RunGraph& run) {
  if (run.window > 1) return fmt::format("windows of {} steps", run.window);
  return run.is_one_pass ? "runs of one pass" : "runs of some passes";
}

std::optional<double> bound_at_capacity(const Prediction& prediction, ExecutorKind executor,
                                        const Point& point) {
  const Capacity& capacity = prediction.capacity;
  if (!capacity.is_known() || point.threads > capacity.threads) return {};
  const bool in_window =
      executor == ExecutorKind::automatic && prediction.auto_run && point.step.clusters != 1;
  const RunGraph& run = in_window ? *prediction.auto_run : prediction.run;
  return capacity.bound(run.work, run.span, point.threads);
}

std::optional<double> Point::error() const {
  if (!measured) return {};
  return step.expected / measured->step.median - 1.0;
}

std::vector<ExecutorKind> predictable_executors() {
  std::vector<ExecutorKind> kinds;
  for (const ExecutorKind kind : graph::executor_kinds())
    if (is_predictable(kind)) kinds.push_back(kind);
  return kinds;
}

std::vector<ExecutorKind> left_out_executors() {
  std::vector<ExecutorKind> kinds;
  for (const ExecutorKind kind : graph::executor_kinds())
    if (kind != ExecutorKind::serial && !is_predictable(kind)) kinds.push_back(kind);
  return kinds;
}

void predict(Prediction& prediction, const graph::StepGraph& graph,
             const graph::StepGraph* auto_graph, const std::vector<int>& threads) {
  const StepPredictor predictor(prediction.run, graph, prediction.runtime);
  std::optional<StepPredictor> of_auto;
  if (auto_graph != nullptr) of_auto.emplace(*prediction.auto_run, *auto_graph, prediction.runtime);
  prediction.serial = predictor.predict(ExecutorKind::serial, 1);
  for (const ExecutorKind kind : predictable_executors()) {
    if (!predictor.can_predict(kind)) continue;
    Series& series = prediction.series.emplace_back(Series{kind, {}});
    for (const int count : threads) {
      const bool in_window = kind == ExecutorKind::automatic && of_auto && count > 1;
      Point point = (in_window ? *of_auto : predictor).predict(kind, count);
      if (in_window && is_serial(point)) {
        point = prediction.serial;
        point.threads = count;
      }
      series.points.push_back(point);
    }
  }
}

void add_measured(Prediction& prediction, const std::vector<compare::Measurement>& measurements) {
  const auto serial = std::find_if(measurements.begin(), measurements.end(), [](const auto& m) {
    return m.configuration.executor == ExecutorKind::serial;
  });
  for (const compare::Measurement& measurement : measurements) {
    Point* const point = find_point(prediction, measurement.configuration);
    if (point == nullptr || measurement.step_times.size() < 2) continue;
    point->measured = {
        compare::quartiles_of(measurement.step_times),
        compare::quartiles_of(compare::ratios(serial->step_times, measurement.step_times))};
  }
}

}  // namespace spoke::predict
