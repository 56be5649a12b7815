#include "tests/bench/reproduce/samples.h"

#include <utility>

using namespace spoke;
using namespace spoke::reproduce;

namespace {

Reproduction idle_machine() {
  Reproduction all{.scenario = {}};
  all.scenario.integration.step = 8e-5;
  all.scenario.integration.duration = 20.0;
  all.machine.cores = 2;
  all.machine.compiler = "GCC 12";
  all.loads = {0.1, 1.0};
  all.rounds = 3;
  return all;
}

}  // namespace

Reproduction reproduction_of(Work work, const Times& times) {
  Reproduction all = idle_machine();
  add_times(work, times, all);
  return all;
}

Reproduction reproduction_of_rounds(
    Work work, const std::vector<std::pair<compare::Configuration, std::vector<double>>>& times) {
  Reproduction all = idle_machine();
  std::vector<compare::Measurement> measurements;
  for (const auto& [configuration, seconds] : times)
    measurements.push_back({.configuration = configuration, .step_times = seconds});
  all.timings.set(work, std::move(measurements));
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
