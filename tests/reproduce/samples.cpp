#include "tests/reproduce/samples.h"

using namespace spoke;
using namespace spoke::reproduce;

Reproduction reproduction_of(Work work, const Times& times) {
  Reproduction all{.scenario = {}};
  all.scenario.integration.step = 8e-5;
  all.scenario.integration.duration = 20.0;
  all.machine.cores = 2;
  all.machine.compiler = "GCC 12";
  all.loads = {0.1, 1.0};
  all.rounds = 3;
  add_times(work, times, all);
  return all;
}

void add_times(Work work, const Times& times, Reproduction& all) {
  std::vector<compare::Measurement> measurements;
  for (const auto& [configuration, seconds] : times) {
    compare::Measurement& measurement = measurements.emplace_back();
    measurement.configuration = configuration;
    measurement.step_times = {seconds, seconds, seconds};
  }
  all.timings.set(work, std::move(measurements));
}
