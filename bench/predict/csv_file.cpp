// The rows of predict.csv.

#include <spdlog/fmt/fmt.h>

#include "bench/predict/files.h"

namespace spoke::predict {
namespace {

constexpr const char* kHeader =
    "executor,threads,predicted_s,optimistic_s,pessimistic_s,predicted_speedup,clusters,"
    "measured_s,measured_speedup,error,window_steps\n";

std::string line_of(const Prediction& prediction, ExecutorKind executor, const Point& point) {
  const std::string measured = point.measured
                                   ? fmt::format("{},{},{}", point.measured->step.median,
                                                 point.measured->speedup.median, *point.error())
                                   : ",,";
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", graph::name_of(executor), point.threads,
                     point.step.expected, point.step.optimistic, point.step.pessimistic,
                     prediction.speedup(point), point.step.clusters, measured, point.window);
}

}  // namespace

std::string make_csv(const Prediction& prediction) {
  std::string text = kHeader + line_of(prediction, ExecutorKind::serial, prediction.serial);
  for (const Series& series : prediction.series)
    for (const Point& point : series.points) text += line_of(prediction, series.executor, point);
  return text;
}

}  // namespace spoke::predict
