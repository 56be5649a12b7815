// Lists of configurations to measure, and access to their times.

#include "bench/reproduce/timings.h"

#include <utility>

namespace spoke::reproduce {

using compare::Configuration;
using compare::Measurement;

std::string_view name_of(Work work) {
  switch (work) {
    case Work::steps:
      return "steps";
    case Work::inverse:
      return "inverse";
    case Work::run:
      break;
  }
  return "run";
}

bool has_schemes() { return graph::has_executor(ExecutorKind::openmp_scheme1); }

Configuration scheme(int number, graph::Threads threads) {
  return {Formulation::subsystem,
          number == 1 ? ExecutorKind::openmp_scheme1 : ExecutorKind::openmp_scheme2, threads};
}

Configuration serial(Formulation formulation) { return {.formulation = formulation}; }

Configuration automatic(Formulation formulation) {
  return {formulation, ExecutorKind::automatic, graph::available_threads()};
}

std::vector<Configuration> configurations_of(Work work) {
  if (work == Work::run) return {serial(Formulation::structured)};
  std::vector<Configuration> list;
  if (work == Work::steps)
    list = {serial(Formulation::augmented), serial(Formulation::structured),
            automatic(Formulation::structured)};
  list.push_back(serial(Formulation::subsystem));
  if (!has_schemes()) return list;
  for (const int number : {1, 2}) {
    if (work == Work::steps)
      for (const int threads : {1, 2}) list.push_back(scheme(number, threads));
    for (const int inner : {1, 2, 3, 4}) list.push_back(scheme(number, {3, inner}));
  }
  return list;
}

void Timings::set(Work work, std::vector<Measurement> measurements) {
  of_[static_cast<std::size_t>(work)] = std::move(measurements);
}

const std::vector<Measurement>& Timings::all(Work work) const {
  return of_[static_cast<std::size_t>(work)];
}

const Measurement* Timings::measurement(Work work, const Configuration& configuration) const {
  for (const Measurement& measurement : all(work)) {
    const Configuration& measured = measurement.configuration;
    if (measured.formulation == configuration.formulation &&
        measured.executor == configuration.executor && measured.threads == configuration.threads)
      return measurement.step_times.empty() ? nullptr : &measurement;
  }
  return nullptr;
}

std::optional<Spread> Timings::find(Work work, const Configuration& configuration) const {
  const Measurement* found = measurement(work, configuration);
  if (found == nullptr) return {};
  return compare::quartiles_of(found->step_times);
}

std::optional<Ratio> Timings::ratio(Work work, const Configuration& above,
                                    const Configuration& below) const {
  const Measurement* first = measurement(work, above);
  const Measurement* second = measurement(work, below);
  if (first == nullptr || second == nullptr) return {};
  return compare::quartiles_of(compare::ratios(first->step_times, second->step_times));
}

Side side_of(const Ratio& ratio, double limit) {
  if (ratio.rounds < kLeastRounds) return Side::untold;
  if (ratio.high < limit) return Side::below;
  return ratio.low > limit ? Side::above : Side::untold;
}

}  // namespace spoke::reproduce
