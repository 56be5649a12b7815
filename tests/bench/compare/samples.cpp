#include "tests/bench/compare/samples.h"

#include <utility>

using namespace spoke;
using namespace spoke::compare;

Measurement measurement_of(ExecutorKind executor, int threads,
                           const std::vector<double>& step_times) {
  Measurement measurement;
  measurement.configuration.executor = executor;
  measurement.configuration.threads = threads;
  measurement.step_times = step_times;
  for (std::uint64_t k = 1; k <= step_times.size() + kWarmUpBatches; ++k)
    measurement.hashes.push_back(k);
  return measurement;
}

Comparison comparison_of(std::vector<Measurement> measurements) {
  Comparison comparison;
  comparison.scenario.title = "Rotor <1>";
  comparison.machine.cpu = "Some processor";
  comparison.machine.cores = 2;
  comparison.loads = {0.1, 1.0};
  comparison.capacity = {2, 1.6, 1.5};
  comparison.rounds = 4;
  comparison.models.push_back({.pass = {.work = 8.0, .span = 2.0}});
  evaluate(comparison, std::move(measurements));
  return comparison;
}
