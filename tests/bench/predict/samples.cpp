#include "tests/bench/predict/samples.h"

using namespace spoke;
using namespace spoke::predict;

namespace {

Point point_of(int threads, int window, double step) {
  return {threads, window, {step, 0.9 * step, 1.1 * step, threads == 1 ? 1 : 3}};
}

}  // namespace

Prediction sample_prediction() {
  Prediction prediction{.scenario = {}};
  prediction.scenario.title = "Rotor <1>";
  prediction.machine.cores = 2;
  prediction.load_before = prediction.load_after = 0.1;
  prediction.run = {.is_one_pass = true, .node_count = 7, .work = 10e-6, .span = 2e-6};
  prediction.auto_run = RunGraph{.window = 50, .node_count = 350, .work = 10e-6, .span = 1e-6};
  prediction.serial = point_of(1, 1, 10e-6);
  return prediction;
}

Series series_of(ExecutorKind executor, const std::vector<std::pair<int, double>>& times,
                 int window) {
  Series series{executor, {}};
  for (const auto& [threads, step] : times)
    series.points.push_back(point_of(threads, threads == 1 ? 1 : window, step));
  return series;
}

void measure_as(double step, double speedup, Point& point) {
  point.measured = {{step, step, step}, {speedup, speedup, speedup}};
}
