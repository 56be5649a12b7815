#include "engine/predict/prediction.h"

#include <algorithm>

#include "engine/compare/statistics.h"

namespace spoke::predict {
namespace {

Quartiles quartiles_of(std::span<const double> values) {
  return {compare::quantile(values, 0.25), compare::median(values),
          compare::quantile(values, 0.75)};
}

/// A run's times as a step's.
graph::PredictedRun per_step(graph::PredictedRun run, const NodeMeasurement& nodes) {
  for (double* seconds : {&run.expected, &run.optimistic, &run.pessimistic})
    *seconds = nodes.runs_per_step * (*seconds + nodes.between_runs);
  return run;
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

std::optional<double> Point::error() const {
  if (!measured) return {};
  return step.expected / measured->step.median - 1.0;
}

std::vector<ExecutorKind> predictable_executors() {
  std::vector<ExecutorKind> kinds;
  for (const ExecutorKind kind : graph::executor_kinds())
    if (kind == ExecutorKind::flow_graph || kind == ExecutorKind::automatic ||
        kind == ExecutorKind::openmp_levels)
      kinds.push_back(kind);
  return kinds;
}

void predict(Prediction& prediction, const graph::StepGraph& graph,
             const std::vector<int>& threads) {
  const NodeMeasurement& nodes = prediction.nodes.serial;
  const graph::RunPredictor predictor(graph, prediction.nodes.costs(), prediction.runtime,
                                      prediction.nodes.spread);
  prediction.work = nodes.runs_per_step * predictor.work();
  prediction.span = nodes.runs_per_step * predictor.span();
  prediction.serial = {1, per_step(predictor.predict(ExecutorKind::serial, 1), nodes), {}};
  for (const ExecutorKind kind : predictable_executors()) {
    if (!predictor.can_predict(kind)) continue;
    Series& series = prediction.series.emplace_back(Series{kind, {}});
    for (const int count : threads)
      series.points.push_back({count, per_step(predictor.predict(kind, count), nodes), {}});
  }
}

void add_measured(Prediction& prediction, const std::vector<compare::Measurement>& measurements) {
  const auto serial = std::find_if(measurements.begin(), measurements.end(), [](const auto& m) {
    return m.configuration.executor == ExecutorKind::serial;
  });
  for (const compare::Measurement& measurement : measurements) {
    Point* const point = find_point(prediction, measurement.configuration);
    if (point == nullptr || measurement.step_times.size() < 2) continue;
    point->measured = {quartiles_of(measurement.step_times),
                       quartiles_of(compare::ratios(serial->step_times, measurement.step_times))};
  }
}

}  // namespace spoke::predict
